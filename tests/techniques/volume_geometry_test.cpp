// What shadow volumes are made of (spec 07): which triangles cast, sides by signed multiplicity,
// closed chains, where counting before the receiver is safe, and the passes of a frame.
#include <numeric>
#include <random>

#include "suites/scenes/procedural/procedural.h"
#include "suites/scenes/procedural/scenes.h"
#include "techniques/volumes/culling/near_pyramid.h"
#include "techniques/volumes/silhouette.h"
#include "tests/techniques/recorded.h"

namespace sb::test {
namespace {

/// Of a mesh that stands where it is, lit from there (w 1) or with light that travels so (w 0).
gpu::VolumeData volumeOf(const Mesh& mesh, uint32_t casts, glm::vec4 light) {
  return {.row0 = {1, 0, 0, 0},
          .row1 = {0, 1, 0, 0},
          .row2 = {0, 0, 1, 0},
          .light = light.w == 0 ? light : glm::vec4(-glm::vec3(light), 1),
          .counts = {0, mesh.triangleCount(), casts, 2},
          .vertices = {6, 6, 1u << VOLUME_SIDES | 1u << VOLUME_CAPS | 1u << VOLUME_TURNED, 0}};
}

Mesh meshOf(std::vector<glm::vec3> positions, std::vector<uint32_t> indices) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.indices = std::move(indices);
  mesh.triangleKeys.resize(mesh.indices.size() / 3);
  return mesh;
}

Mesh cube() {
  std::vector<glm::vec3> p;
  for (int i = 0; i < 8; ++i) p.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  return meshOf(p, {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5});
}

Silhouette of(const Mesh& mesh, uint32_t casts, glm::vec4 light) {
  return silhouette(mesh, edgeMesh(mesh), volumeOf(mesh, casts, light));
}

Mesh randomSoup(uint32_t seed) {
  std::mt19937 random(seed);
  Mesh mesh = meshOf({}, {});
  for (int i = 0; i < 12; ++i) {
    const auto c = [&] { return float(int(random() % 9) - 4) / 4; };
    mesh.positions.emplace_back(c(), c(), c());
  }
  for (int t = 0; t < 60; ++t)
    for (int k = 0; k < 3; ++k) mesh.indices.push_back(random() % 12);
  mesh.triangleKeys.resize(60);
  return mesh;
}

TEST(ShadowVolume, ATetrahedronHasSixEdgesAndFourTimesItsTriangles) {
  const Mesh mesh =
      meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
  const EdgeMesh edges = edgeMesh(mesh);
  ASSERT_TRUE(edges.closed);
  EXPECT_EQ(edges.edges.size(), 6u);
  // The source's mesh: each triangle, and a quad at each edge.
  EXPECT_EQ(mesh.triangleCount() + 2 * edges.edges.size(), 16u);
  EXPECT_EQ(3 * mesh.triangleCount(), 6u * 4 - 12);
}

TEST(ShadowVolume, ACubeLitFromAboveHasTwelveTriangles) {
  for (const glm::vec4 light : {glm::vec4(0, 0, 5, 1), glm::vec4(0, 0, -1, 0)}) {
    const Silhouette items = of(cube(), CASTS_LIGHT, light);
    EXPECT_EQ(items[VOLUME_CAPS].size(), 2u);
    EXPECT_EQ(items[VOLUME_TURNED].size(), 0u);
    EXPECT_EQ(items[VOLUME_SIDES].size(), 4u) << "the diagonal has none";
    EXPECT_EQ(2 * items[VOLUME_CAPS].size() + 2 * items[VOLUME_SIDES].size(), 12u);
  }
  // All others have their back to it; those in its plane, too.
  EXPECT_EQ(of(cube(), CASTS_BACK, {0, 0, -1, 0})[VOLUME_TURNED].size(), 10u);
  EXPECT_EQ(of(cube(), CASTS_BACK, {0, 0, -1, 0})[VOLUME_SIDES].size(), 4u);
  const Silhouette all = of(cube(), CASTS_ALL, {0, 0, -1, 0});
  EXPECT_EQ(all[VOLUME_CAPS].size(), 2u);
  EXPECT_EQ(all[VOLUME_TURNED].size(), 2u) << "walls along the light cast nothing";
}

TEST(ShadowVolume, ThreeTrianglesAtAnEdgeHaveOneSideThere) {
  // Two go a -> b, one b -> a; the light is far along z, and all face it.
  const Mesh mesh = meshOf({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {-2, 0, 0.1f}, {1, 0, 0}},
                           {0, 1, 2, 0, 1, 3, 1, 0, 4});
  const Silhouette items = of(mesh, CASTS_ALL, {0, 0.5f, 50, 1});
  ASSERT_EQ(items[VOLUME_CAPS].size() + items[VOLUME_TURNED].size(), 3u);
  const EdgeMesh edges = edgeMesh(mesh);
  const auto at = std::ranges::count_if(items[VOLUME_SIDES], [&](uint32_t item) {
    const glm::uvec4 ends = edges.edges[item >> 1].ends;
    return ends.x == 0 && ends.y == 1;
  });
  EXPECT_EQ(at, 1);
}

TEST(ShadowVolume, SidesOfAnySoupAreAClosedChain) {
  for (uint32_t seed = 0; seed < 50; ++seed) {
    const Mesh mesh = randomSoup(seed);
    const EdgeMesh edges = edgeMesh(mesh);
    for (const uint32_t casts : {CASTS_LIGHT, CASTS_BACK, CASTS_ALL})
      for (const glm::vec4 light : {glm::vec4(3, 5, 2, 1), glm::vec4(0.1f, 0.2f, 0.1f, 1),
                                    glm::vec4(0.3f, -1, 0.25f, 0), glm::vec4(1, 0, 0, 0)}) {
        const Silhouette items = of(mesh, casts, light);
        std::map<uint32_t, int> balance;
        for (const uint32_t item : items[VOLUME_SIDES]) {
          const glm::uvec4 ends = edges.edges[item >> 1].ends;
          balance[item & 1 ? ends.y : ends.x] -= 1;
          balance[item & 1 ? ends.x : ends.y] += 1;
        }
        for (const auto& [vertex, sum] : balance) EXPECT_EQ(sum, 0) << seed << ", " << vertex;
      }
  }
}

TEST(ShadowVolume, PartsThatAreTurnedInsideOutAreTold) {
  EXPECT_EQ(edgeMesh(cube()).winding, 1);
  Mesh inward = cube();
  for (size_t i = 0; i < inward.indices.size(); i += 3)
    std::swap(inward.indices[i], inward.indices[i + 1]);
  EXPECT_EQ(edgeMesh(inward).winding, -1);
  Mesh both = cube();
  const auto other = uint32_t(both.positions.size());
  for (const glm::vec3& p : inward.positions) both.positions.push_back(p + glm::vec3(5, 0, 0));
  for (const uint32_t i : inward.indices) both.indices.push_back(i + other);
  both.triangleKeys.resize(both.indices.size() / 3);
  EXPECT_EQ(edgeMesh(both).winding, 0);
  EXPECT_TRUE(edgeMesh(both).closed);
}

TEST(ShadowVolume, CastersBetweenLightAndNearRectangleAreFound) {
  const Camera camera = lookAt({0, 0, 0}, {0, 0, -1}, 1.0);
  const auto near = nearRectangle(camera, 1.5);
  const glm::dvec4 above(0, 10, -0.1, 1), behind(0, 0, 10, 1);
  EXPECT_TRUE(meetsNearPyramid(near, above, {0, 5, -0.1}, 0.1)) << "a light in its plane";
  EXPECT_FALSE(meetsNearPyramid(near, {0, 10, -5, 1}, {2, 5, -2.5}, 0.5)) << "beside";
  EXPECT_FALSE(meetsNearPyramid(near, {0, 10, -5, 1}, {0, 5, 1}, 0.1)) << "behind the rectangle";
  EXPECT_TRUE(meetsNearPyramid(near, {0, 10, -5, 1}, {0, 5, -2.5}, 0.5));
  EXPECT_FALSE(meetsNearPyramid(near, {0, 1, -1, 0}, {0, 5, 5}, 0.1));
  EXPECT_TRUE(meetsNearPyramid(near, {0, 1, -1, 0}, {0, 5, -5}, 0.5));
  EXPECT_TRUE(meetsNearPyramid(near, behind, {0, 0, 5}, 0.1)) << "between a light behind and it";
  EXPECT_FALSE(meetsNearPyramid(near, behind, {0, 0, -5}, 0.1)) << "before the eye";
  // In the rectangle's plane there is no pyramid.
  EXPECT_TRUE(meetsNearPyramid(near, {5, 5, -camera.nearPlane, 1}, {100, 0, 0}, 0.1));
}

TEST(ShadowVolume, TheBenchmarkScenesHaveTheEdgesOfTheSource) {
  const auto device = null_backend::makeBackend()->open({});
  CellDevice shared(*device);
  for (const auto& [lights, objects, edges] :
       {std::tuple{1, 1, 4.0}, {2, 4, 64.0}, {7, 10, 538.0}, {7, 13, 756.0}}) {
    const Scene scene = makeScene("wedges:lights=" + std::to_string(lights) +
                                  ",objects=" + std::to_string(objects));
    Cell cell(shared, scene, {.technique = "StencilShadowVolume", .knobs = {{"cull", "none"}}});
    const auto counts = cell.renderer().counts();
    const std::map<std::string, uint64_t> named(counts.begin(), counts.end());
    // The floor is a sheet with four edges.
    EXPECT_NEAR(double(named.at("silhouette edges")) - 4 * lights, edges, 0.05 * edges);
  }
}

TEST(ShadowVolumePasses, OnlyLightsThatSomethingCastsInHaveSome) {
  Scene scene = opaqueScene();
  const std::vector<std::string> one = {"depth prepass", "shadow volumes", "shadow mask", "opaque"};
  EXPECT_EQ(passes(record(scene, "StencilShadowVolume")), one);
  EXPECT_EQ(passes(record(scene, "StencilShadowVolume", {{"counter", "float"}})), one);
  // A lamp that reaches a pane alone.
  Scene pane = withPane(scene);
  const auto without = passes(record(pane, "StencilShadowVolume"));
  Light lamp = pointLight({0, 1.625, 0}, 1);
  lamp.range = 0.25;
  addLight(pane, lamp);
  EXPECT_EQ(passes(record(pane, "StencilShadowVolume")), without);
  Scene two = scene;
  addLight(two, spotLight({0, 4, 0}, {0, -1, 0}, 0.7));
  EXPECT_EQ(passes(record(two, "StencilShadowVolume")),
            (std::vector<std::string>{"depth prepass", "shadow volumes", "shadow mask",
                                      "shadow volumes", "shadow mask", "opaque"}));
  Scene unlit = scene;
  unlit.lights.clear();
  EXPECT_EQ(passes(record(unlit, "StencilShadowVolume")), std::vector<std::string>{"opaque"});
}

TEST(ShadowVolumePasses, BuildsDifferInWhatTheyDraw) {
  const Scene scene = opaqueScene();
  const auto build = [&](const char* name) {
    return record(scene, "StencilShadowVolume", {{"build", name}, {"count", "zfail"}});
  };
  const auto triangles = [](const Recorded& r) {
    for (const PassResult& p : r.frame.passes)
      if (p.label == "shadow volumes") return p.counters.triangles;
    return uint64_t(0);
  };
  const Recorded cpu = build("cpu"), everywhere = build("vertex"), compute = build("compute");
  EXPECT_LT(triangles(cpu), triangles(everywhere) / 2);
  EXPECT_EQ(passes(compute).front(), "silhouettes");
  EXPECT_EQ(cpu.bytes.contains("shadow volume lists"), true);
  EXPECT_EQ(everywhere.bytes.contains("shadow volume lists"), false);
  EXPECT_EQ(compute.bytes.contains("shadow volume arguments"), true);
}

TEST(ShadowVolumePasses, WholePerforatedAndTranslucentCastersAreUnrepresented) {
  Scene scene = withPane(opaqueScene());
  Material holes = matte();
  holes.alphaMode = AlphaMode::Mask;
  holes.baseColorTexture.image = 0;
  scene.images.push_back({"holes", 2, 1, {255, 255, 255, 255, 255, 255, 255, 0}});
  addHorizontal(scene, add(scene, holes), {1, 1, 1}, 0.5f, 0.5f);
  const Recorded r = record(scene, "StencilShadowVolume");
  for (const Effect effect :
       {Effect::PerforatedCasters, Effect::TranslucentCasters, Effect::ColouredTransmission})
    EXPECT_EQ(std::ranges::count(r.plan.unrepresented, effect), 1) << effectName(effect);
  scene.lights[0].angularRadius = 0.01;
  EXPECT_EQ(std::ranges::count(record(scene, "StencilShadowVolume").plan.unrepresented,
                               Effect::AreaLights),
            1);
}

}  // namespace
}  // namespace sb::test
