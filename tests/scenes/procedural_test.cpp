// Procedural scenes: specs, determinism, and what the source document says of each.
#include "suites/scenes/procedural/procedural.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "suites/scenes/analysis/analysis.h"
#include "suites/scenes/analysis/view_volume.h"
#include "techniques/plan/error.h"
#include "techniques/scene/box.h"
#include "techniques/scene/light_area.h"
#include "techniques/scene/tree/region.h"

namespace sb {
namespace {

void expectError(const std::string& spec, const std::vector<std::string>& parts) {
  try {
    makeScene(spec);
    ADD_FAILURE() << spec << " was made";
  } catch (const InputError& e) {
    for (const std::string& part : parts)
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

TEST(Procedural, SpecsAreChecked) {
  expectError("windo", {"unknown scene 'windo'", "window", ".gltf"});
  expectError("layers:alfa=1", {"unknown parameter of layers 'alfa'", "alpha"});
  expectError("layers:alpha=2", {"alpha is '2'", "from 0 to 1"});
  expectError("layers:alpha=", {"alpha is ''"});
  expectError("layers:alpha=nan", {"alpha is 'nan'"});
  expectError("layers:alpha", {"parameter=value"});
  expectError("layers:", {"parameter=value"});
  expectError("layers:alpha=.5,alpha=.6", {"alpha is given twice"});
  expectError("spheres_quads:quads=1.5", {"whole number from 0 to 2000"});
  expectError("spheres_quads:orientation=alined", {"'alined'", "aligned"});
  expectError("absent.gltf", {"absent.gltf", "file not found"});
}

TEST(Procedural, CanonicalSpecs) {
  EXPECT_EQ(canonicalSceneSpec("layers"), "layers");
  EXPECT_EQ(canonicalSceneSpec("layers:alpha=0.60"), "layers");
  EXPECT_EQ(canonicalSceneSpec("spheres_quads:orientation=random,quads=500,size=1"),
            "spheres_quads:quads=500,orientation=random");
  EXPECT_EQ(canonicalSceneSpec("a/b.GLB"), "a/b.GLB");
  EXPECT_EQ(makeScene("layers:sun=0.5,alpha=.6").name, "layers:sun=0.5");
}

TEST(Procedural, InfosAreComplete) {
  EXPECT_EQ(proceduralScenes().size(), 11u);
  for (const SceneInfo& scene : proceduralScenes()) {
    EXPECT_FALSE(scene.help.empty());
    for (const SceneParam& param : scene.params) {
      EXPECT_FALSE(param.help.empty()) << scene.name << " " << param.name;
      EXPECT_EQ(canonicalSceneSpec(scene.name + ":" + param.name + "=" + param.fallbackText()),
                scene.name);
    }
  }
}

TEST(Procedural, LampsStandWhereTheSunComesFrom) {
  for (const std::string scene : {"teapot", "window"}) {
    const glm::dvec3 along = makeScene(scene).lights[0].direction;
    for (const std::string shape : {"ellipsoid", "rectangle", "disc", "sphere"}) {
      const Light lamp = makeScene(scene + ":light=" + shape + ",lamp=2").lights[0];
      EXPECT_EQ(lamp.type, LightType::Point);
      EXPECT_EQ(isSphere(lamp), shape == "sphere");
      EXPECT_NEAR(glm::length(lamp.halfAxes[0]), 2, 1e-12);
      EXPECT_GT(lamp.intensity, 600) << "3.14 lux from 14 away and more";
      EXPECT_NEAR(glm::length(lamp.direction - along), 0, 1e-12);
      // Flat ones face what they light.
      if (shape == "rectangle")
        EXPECT_NEAR(glm::length(glm::cross(lamp.halfAxes[0], lamp.halfAxes[1]) + 2.0 * along), 0,
                    1e-12);
    }
  }
  EXPECT_EQ(makeScene("penumbra").lights[0].halfAxes, glm::dmat3(0.5));
  EXPECT_FALSE(isAreaLight(makeScene("penumbra:size=0").lights[0]));
  EXPECT_EQ(makeScene("penumbra:light=disc").lights[0].shape, LightShape::Disc);
}

TEST(Procedural, SameSpecSameScene) {
  for (const std::string spec :
       {"spheres_quads", "spheres_quads:orientation=random", "layers", "panes", "window",
        "teapot"}) {
    const Scene a = makeScene(spec), b = makeScene(spec);
    ASSERT_EQ(a.instances.size(), b.instances.size());
    for (size_t i = 0; i < a.instances.size(); ++i)
      ASSERT_EQ(a.instances[i].toWorld, b.instances[i].toWorld);
    for (size_t i = 0; i < a.images.size(); ++i) ASSERT_EQ(a.images[i].rgba, b.images[i].rgba);
    for (size_t i = 0; i < a.meshes.size(); ++i)
      ASSERT_EQ(a.meshes[i].positions, b.meshes[i].positions);
  }
  const Scene one = makeScene("spheres_quads"), two = makeScene("spheres_quads:seed=2");
  EXPECT_NE(one.instances[5].toWorld, two.instances[5].toWorld);
  // These numbers must not change: results name the scene by its spec.
  EXPECT_DOUBLE_EQ(one.instances[1].toWorld[3][0],
                   makeScene("spheres_quads:quads=0").instances[1].toWorld[3][0]);
}

TEST(Procedural, EveryInstanceLiesInView) {
  for (const double aspect : {1.0, 4.0 / 3.0})
    for (const std::string spec : {"layers", "panes", "window", "teapot"}) {
      const Scene scene = makeScene(spec);
      const ViewVolume view(scene.camera(), aspect);
      for (const Instance& instance : scene.instances) {
        if (instance.name == "floor") continue;
        const Box screen = view.onScreen(instanceBox(scene, instance, scene.camera().eye()));
        EXPECT_GT(screen.low.x, -1.0) << spec << " " << instance.name << " " << aspect;
        EXPECT_LT(screen.high.x, 1.0) << spec << " " << instance.name << " " << aspect;
        EXPECT_GT(screen.low.y, -1.0) << spec << " " << instance.name;
        EXPECT_LT(screen.high.y, 1.0) << spec << " " << instance.name;
      }
    }
}

TEST(Procedural, CentresOfPanesTellTheWrongOrder) {
  const Scene scene = makeScene("panes");
  const glm::dvec3 eye = scene.camera().eye();
  const auto distance = [&](size_t i) {
    return glm::length(instanceBox(scene, scene.instances[i]).center() - eye);
  };
  // Green, red, blue: by centres red is behind green and blue before it.
  EXPECT_GT(distance(2), distance(1));
  EXPECT_LT(distance(3), distance(1));
  // Where they are, it is the other way round: green's z is 0.6 x.
  EXPECT_GT(scene.instances[2].toWorld[3].z, 0.6 * (scene.instances[2].toWorld[3].x + 0.8));
  EXPECT_LT(scene.instances[3].toWorld[3].z, 0.6 * (scene.instances[3].toWorld[3].x - 0.8));
}

TEST(Procedural, SpheresAndQuads) {
  const Scene scene = makeScene("spheres_quads:quads=2000");
  EXPECT_EQ(scene.instances.size(), 1u + 1000 + 2000);
  EXPECT_EQ(scene.meshes.size(), 3u);
  Box spheres, quads;
  for (const Instance& i : scene.instances) {
    if (i.name.starts_with("sphere")) spheres.add(instanceBox(scene, i));
    if (i.name.starts_with("quad")) quads.add(instanceBox(scene, i));
  }
  EXPECT_TRUE(spheres.touches(quads));
  EXPECT_GT(quads.high.y, spheres.high.y + 2);  // the light comes from above
  const Material& blue = scene.materials[scene.meshes[2].material];
  EXPECT_EQ(blue.baseColor.a, 0.25f);
  EXPECT_EQ(blue.alphaMode, AlphaMode::Blend);
  // Aligned quads face the light.
  const glm::dvec3 normal = glm::normalize(glm::dvec3(scene.instances.back().toWorld[2]));
  EXPECT_NEAR(glm::dot(normal, scene.lights[0].direction), -1, 1e-12);
  // Fewer quads are the first of more.
  const Scene fewer = makeScene("spheres_quads:quads=7");
  EXPECT_EQ(fewer.instances.back().toWorld, scene.instances[1007].toWorld);
}

TEST(Procedural, TheYardsTreeHangsTogether) {
  for (int seed = 1; seed <= 40; ++seed) {
    const Scene scene = makeScene("yard:casters=0,seed=" + std::to_string(seed));
    Box trunk;
    std::vector<Sphere> balls;
    for (const Instance& i : scene.instances) {
      const Box box = instanceBox(scene, i);
      if (i.name == "trunk") trunk = box;
      if (i.name.starts_with("crown"))
        balls.push_back({box.center(), (box.high.x - box.low.x) / 2});
    }
    ASSERT_EQ(balls.size(), 7u);
    ASSERT_FALSE(trunk.empty());
    std::vector<Sphere> held;
    const auto holds = [&](const Sphere& ball) {
      const glm::dvec3 nearest = glm::clamp(ball.center, trunk.low, trunk.high);
      return glm::distance(nearest, ball.center) < ball.radius ||
             std::ranges::any_of(held, [&](const Sphere& other) {
               return glm::distance(other.center, ball.center) < other.radius + ball.radius;
             });
    };
    for (size_t round = 0; round < 7; ++round)
      std::erase_if(balls, [&](const Sphere& ball) {
        const bool found = holds(ball);
        if (found) held.push_back(ball);
        return found;
      });
    EXPECT_TRUE(balls.empty()) << "seed " << seed;
  }
}

TEST(Procedural, WindowHasLeadAndGlassOfEveryKind) {
  const Scene scene = makeScene("window");
  const Image& image = scene.images.at(0);
  ASSERT_GE(image.width, 1024u);
  size_t lead = 0, deep = 0, pale = 0;
  for (size_t i = 0; i < image.rgba.size(); i += 4) {
    const uint8_t* t = image.rgba.data() + i;
    const int brightest = std::max({t[0], t[1], t[2]}), darkest = std::min({t[0], t[1], t[2]});
    lead += brightest == 0 && t[3] == 255;
    deep += brightest > 200 && darkest < 80 && t[3] > 200;
    pale += darkest > 150 && t[3] < 128;
  }
  const size_t texels = image.rgba.size() / 4;
  for (const size_t kind : {lead, deep, pale}) EXPECT_GT(kind, texels / 50);
  // Eight axes of symmetry at least in its outline: a quarter turn maps lead to lead.
  size_t differs = 0;
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = 0; x < image.width; ++x)
      differs += image.rgba[4 * (y * image.width + x) + 3] !=
                 image.rgba[4 * (x * image.width + image.width - 1 - y) + 3];
  EXPECT_LT(differs, texels / 50);
}

TEST(Procedural, TeapotIsClosedButForItsEndsAndFacesOutward) {
  const Scene scene = makeScene("teapot");
  const Mesh& pot = scene.meshes.at(1);
  EXPECT_EQ(pot.name, "teapot");
  // Every edge is used once in each direction, but for the open ends: spout's mouth and foot, the
  // handle's two ends (4 circles), wherever its ends lie inside the body.
  std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int> edges;
  const auto key = [&](uint32_t i) {
    const glm::vec3 p = pot.positions[i];
    return std::array<float, 3>{p.x, p.y, p.z};
  };
  double volume = 0;
  size_t wrongNormals = 0;
  for (size_t t = 0; t < pot.indices.size(); t += 3) {
    const uint32_t* i = pot.indices.data() + t;
    for (int c = 0; c < 3; ++c) ++edges[{key(i[c]), key(i[(c + 1) % 3])}];
    const glm::dvec3 a = pot.positions[i[0]], b = pot.positions[i[1]], c = pot.positions[i[2]];
    volume += glm::dot(a, glm::cross(b, c)) / 6;
    const glm::dvec3 face = glm::normalize(glm::cross(b - a, c - a));
    for (int k = 0; k < 3; ++k) wrongNormals += glm::dot(face, glm::dvec3(pot.normals[i[k]])) < 0.2;
  }
  size_t open = 0, doubled = 0;
  for (const auto& [edge, uses] : edges) {
    open += !edges.contains({edge.second, edge.first});
    doubled += uses > 1;
  }
  EXPECT_EQ(doubled, 0u);
  EXPECT_GT(volume, 5);
  EXPECT_LT(open, 4u * 4 * 10 + 1);
  EXPECT_LT(wrongNormals, pot.indices.size() / 50);
}

}  // namespace
}  // namespace sb
