// Stencil shadow volumes (spec 07): exact to the pixel for any caster, any light and any eye; the
// same picture however they are built and counted; what settings break by construction.
#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/procedural.h"
#include "suites/scenes/procedural/scenes.h"
#include "suites/scenes/procedural/shapes.h"
#include "tests/techniques/shadow_volume_truth.h"

using namespace sb;
using namespace sb::test;

namespace {

using Setting = std::map<std::string, std::string>;

CellOptions volumes(Setting knobs = {}, rhi::Extent2D size = {96, 64}) {
  return {.technique = "StencilShadowVolume", .knobs = std::move(knobs), .size = size};
}

/// A closed box, a sphere, sheets and a box without a lid over a floor.
Scene stage(bool localLights) {
  Scene scene;
  const uint32_t grey = add(scene, matte()), red = add(scene, matte({0.75f, 0.25f, 0.125f}));
  Material thin = matte({0.25f, 0.5f, 0.75f});
  thin.doubleSided = true;
  const uint32_t sheet = add(scene, thin);
  addHorizontal(scene, grey, {0, 0, 0}, 4, 4);
  addBox(scene, red, {-1.5f, 0, -1}, {-0.5f, 1.25f, 0});
  place(scene, add(scene, sphereMesh("ball", red, 8)),
        translation({0.75, 0.5, 0.75}) * glm::dmat4(glm::dmat3(0.5)));
  addQuad(scene, sheet, {0.5f, 1.5f, -0.5f}, {0.75f, 0.25f, 0}, {0, 0.25f, 0.5f});
  addQuad(scene, grey, {-0.75f, 1.75f, 1.25f}, {0.5f, 0, 0.25f}, {0, 0.25f, 0.75f});
  addLight(scene, sun({0.375, -1, -0.25}));
  if (localLights) {
    addLight(scene, pointLight({1.5, 2.25, 0.5}, 4));
    addLight(scene, spotLight({-1.5, 3, 1.5}, {0.5, -1, -0.5}, 0.75, 6));
  }
  scene.cameras.push_back(lookAt({2.5, 3, 4}, {0, 0.25, 0}));
  return scene;
}

/// The eye in the shadow of a box, the near rectangle across its boundary.
Scene eyeInShadow() {
  Scene scene = stage(true);
  addBox(scene, 1, {-2.5f, 2.5f, -2.5f}, {-1.5f, 3, -1.5f});
  scene.cameras[0] = lookAt({-1.4, 0.6, -1.6}, {0.5, 0.3, 1});
  scene.cameras[0].nearPlane = 0.3;
  return scene;
}

/// Every material opaque.
Scene opaque(Scene scene) {
  for (Material& material : scene.materials) {
    material.alphaMode = AlphaMode::Opaque;
    material.opticsOverride = false;
    material.transmission = 0;
  }
  return scene;
}

const std::vector<Setting> kBuilds = {
    {{"build", "cpu"}}, {{"build", "vertex"}}, {{"build", "compute"}}};

}  // namespace

GPU_TEST(ShadowVolumes, AreExactForEveryLight) {
  for (const Setting& setting : std::vector<Setting>{{},
                                                     {{"count", "zfail"}},
                                                     {{"casts", "all"}},
                                                     {{"sides", "one"}},
                                                     {{"counter", "float"}}}) {
    Cell cell(cellDevice(device()), stage(true), volumes(setting));
    expectExact(cell, setting.empty() ? "auto" : setting.begin()->second, 300);
  }
}

GPU_TEST(ShadowVolumes, AreExactWhereverTheEyeIs) {
  for (const Setting& setting :
       std::vector<Setting>{{}, {{"count", "zfail"}}, {{"counter", "float"}}}) {
    Cell cell(cellDevice(device()), eyeInShadow(), volumes(setting));
    expectExact(cell, "in the shadow of a box");
  }
}

GPU_TEST(ShadowVolumes, AreExactForCurvedCasters) {
  Cell cell(cellDevice(device()), opaque(makeScene("teapot")), volumes({}, {128, 96}));
  expectExact(cell, "teapot", 300);
  Cell spheres(cellDevice(device()), opaque(makeScene("spheres_quads")), volumes({}, {128, 96}));
  expectExact(spheres, "spheres", 300);
}

GPU_TEST(ShadowVolumes, EveryBuildDrawsTheSameBits) {
  const auto known = [&](const Scene& scene, Setting knobs) {
    std::vector<std::vector<float>> pictures;
    for (const Setting& build : kBuilds) {
      Setting all = knobs;
      all.insert(build.begin(), build.end());
      Cell cell(cellDevice(device()), scene, volumes(all));
      pictures.push_back(cell.picture().rgba);
      EXPECT_EQ(pictures.back(), pictures.front()) << build.begin()->second;
    }
    return pictures.front();
  };
  for (const Scene& scene : {stage(true), eyeInShadow()}) {
    const std::vector<float> picture = known(scene, {});
    EXPECT_EQ(known(scene, {{"count", "zfail"}}), picture);
    EXPECT_EQ(known(scene, {{"casts", "all"}}), picture);
    EXPECT_EQ(known(scene, {{"sides", "one"}}), picture);
    EXPECT_EQ(known(scene, {{"counter", "float"}}), picture);
  }
}

GPU_TEST(ShadowVolumes, LightsAndEyesWithinCastersAreRight) {
  // A light in a closed box over a floor, seen from outside and from within; the sun over a room
  // without windows.
  const auto scene = [](glm::dvec3 eye, glm::dvec3 target, bool lamp, bool inward = false) {
    Scene s = floorScene(false);
    s.materials[0].doubleSided = false;
    const uint32_t box = addBox(s, 0, {-1, 0.5f, -1}, {1, 2.5f, 1});
    Mesh& mesh = s.meshes[s.instances[box].mesh];
    for (size_t i = 0; inward && i < mesh.indices.size(); i += 3)
      std::swap(mesh.indices[i], mesh.indices[i + 1]);
    addBox(s, 0, {-0.5f, 0.6f, -0.5f}, {0.25f, 1, 0.25f});
    addLight(s, lamp ? pointLight({0.5, 2, 0.5}, 10) : sun({0.25, -1, 0.125}));
    s.cameras[0] = lookAt(eye, target);
    return s;
  };
  const glm::dvec3 outside(2.5, 3, 3), inside(0.8, 2.3, 0.8), middle(0, 0.8, 0);
  for (const Setting& setting : std::vector<Setting>{{}, {{"count", "zfail"}}}) {
    const auto exact = [&](const Scene& s, const char* what) {
      Cell cell(cellDevice(device()), s, volumes(setting));
      expectExact(cell, what);
    };
    exact(scene(outside, middle, true), "a lamp in a box");
    exact(scene(outside, middle, false), "a box in the sun");
    Scene doubled = scene(inside, middle, true);
    doubled.materials[0].doubleSided = true;
    exact(doubled, "a room with a lamp");
    Scene dark = scene(inside, middle, false);
    dark.materials[0].doubleSided = true;
    exact(dark, "a room in the sun");
    exact(scene(outside, middle, true, true), "a box inside out with a lamp");
    exact(scene(outside, middle, false, true), "a box inside out in the sun");
    exact(scene(inside, middle, false, true), "a room inside out in the sun");
  }
}

GPU_TEST(ShadowVolumes, AnySoupIsRight) {
  // Boxes without a wall, triangles twice, turned over and without area, three at an edge.
  Scene scene = stage(true);
  Mesh& box = scene.meshes[scene.instances[1].mesh];
  box.indices.resize(box.indices.size() - 6);
  box.triangleKeys.resize(box.triangleKeys.size() - 2);
  for (const uint32_t i : {0u, 1u, 2u, 3u, 5u, 4u, 7u, 7u, 8u, 0u, 2u, 20u})
    box.indices.push_back(i);
  for (int i = 0; i < 4; ++i) box.triangleKeys.push_back(uint32_t(100 + i));
  for (Material& material : scene.materials) material.doubleSided = true;
  for (const Setting& setting :
       std::vector<Setting>{{}, {{"count", "zfail"}}, {{"counter", "float"}}}) {
    Cell cell(cellDevice(device()), scene, volumes(setting));
    expectExact(cell, setting.empty() ? "soup" : setting.begin()->second, 300);
  }
  Scene doubled = stage(true);
  duplicateOpaque(doubled);
  insertDegenerate(doubled);
  Cell once(cellDevice(device()), stage(true), volumes());
  Cell twice(cellDevice(device()), doubled, volumes());
  EXPECT_EQ(once.picture().rgba, twice.picture().rgba);
}

GPU_TEST(ShadowVolumes, SingleSidedCastersThatTheEyeSeesThroughStillCast) {
  // From below, a sheet is not drawn; its shadow on the floor is, and the wall that is seen through
  // it is lit.
  Scene scene;
  const uint32_t grey = add(scene, matte());
  scene.materials[grey].doubleSided = false;
  addQuad(scene, grey, {0, 1, -4}, {6, 0, 0}, {0, 6, 0});
  addHorizontal(scene, grey, {0, -1, 0}, 6, 6);
  addHorizontal(scene, grey, {0, 1, -1}, 1, 0.5f);
  addLight(scene, sun({0, -1, -0.25}));
  scene.cameras.push_back(lookAt({0, 0.25, 0.5}, {0, 1, -4}, 1.4));
  for (const char* count : {"auto", "zpass", "zfail"}) {
    Cell cell(cellDevice(device()), scene, volumes({{"count", count}}));
    expectExact(cell, count);
  }
}

GPU_TEST(ShadowVolumes, OrthographicEyesSeeTheSame) {
  Scene scene = stage(true);
  Camera camera = lookAt({2.5, 3, 4}, {0, 0.25, 0});
  camera.orthographic = true;
  camera.halfHeight = 2;
  scene.cameras[0] = camera;
  for (const char* count : {"auto", "zpass", "zfail"}) {
    Cell cell(cellDevice(device()), scene, volumes({{"count", count}}));
    expectExact(cell, count, 300);
  }
}

GPU_TEST(ShadowVolumes, TranslucentLayersThatArePeeledReceive) {
  Scene scene = stage(true);
  addQuad(scene, add(scene, glass(0.5f, glm::vec3(1))), {0.25f, 0.75f, 1.5f}, {2, 0, 0},
          {0, 0.75f, 0.25f});
  Cell cell(cellDevice(device()), scene,
            {.technique = "StencilShadowVolume", .size = {96, 64}, .transparency = "DepthPeeling"});
  for (const uint32_t layer : {1u, 2u}) {
    const ShadowMismatch m = shadowMismatch(cell, layer);
    EXPECT_EQ(m.elsewhere, 0u) << layer << ", " << m.first;
    EXPECT_LE(double(m.atEdges), double(m.edge) / 5 / 64 + 4) << layer;
    EXPECT_GE(m.dark, 100u) << layer;
  }
}

GPU_TEST(ShadowVolumes, WhatSettingsBreakIsWhatTheySay) {
  // Counting before the receiver, with the eye in a volume.
  Cell pass(cellDevice(device()), eyeInShadow(), volumes({{"count", "zpass"}}));
  EXPECT_GT(shadowMismatch(pass).elsewhere, 500u);
  // One side of an open mesh: a sheet with its back to the light.
  Scene sheet = floorScene(false);
  addHorizontal(sheet, 0, {0, 1, 0}, 1, 1);
  addLight(sheet, sun({0, -1, 0}));
  const auto dark = [&](const Scene& scene, Setting knobs) {
    Cell cell(cellDevice(device()), scene, volumes(std::move(knobs), {40, 40}));
    return shadowMismatch(cell);
  };
  EXPECT_EQ(dark(sheet, {}).elsewhere, 0u);
  EXPECT_EQ(dark(sheet, {{"casts", "light"}}).elsewhere, 0u);
  EXPECT_GT(dark(sheet, {{"casts", "back"}}).elsewhere, 20u);
  // A lamp in a box: no triangle faces outward to it.
  Scene lamp = floorScene(false);
  addBox(lamp, 0, {-1, 1, -1}, {1, 3, 1});
  addLight(lamp, pointLight({0, 2, 0}, 10));
  EXPECT_EQ(dark(lamp, {}).elsewhere, 0u);
  EXPECT_EQ(dark(lamp, {{"casts", "back"}}).elsewhere, 0u);
  EXPECT_GT(dark(lamp, {{"casts", "light"}}).elsewhere, 500u);
}

GPU_TEST(ShadowVolumes, CountersWrapWhereTheySay) {
  for (const uint32_t layers : {255u, 256u, 257u, 512u}) {
    Scene scene = floorScene();
    Mesh sheets = quadMesh(0, {0, 1, 0}, {1, 0, 0}, {0, 0, -1});
    for (uint32_t i = 1; i < layers; ++i) {
      const auto first = uint32_t(sheets.positions.size());
      for (uint32_t c = 0; c < 4; ++c) {
        sheets.positions.push_back(sheets.positions[c] + glm::vec3(0, float(i) / 256, 0));
        sheets.normals.push_back(sheets.normals[c]);
      }
      for (uint32_t c = 0; c < 6; ++c) sheets.indices.push_back(sheets.indices[c] + first);
      for (uint32_t c = 0; c < 2; ++c) sheets.triangleKeys.push_back(2 * i + c);
    }
    sheets.uv0.clear();
    sheets.boundsMax.y = 4;
    place(scene, add(scene, sheets));
    for (const char* counter : {"stencil8", "float"}) {
      Cell cell(cellDevice(device()), scene, volumes({{"counter", counter}}, {40, 40}));
      const float middle = cell.visibility()[0][4 * (20 * 40 + 20)];
      const bool wraps = std::string(counter) == "stencil8" && layers % 256 == 0;
      EXPECT_EQ(middle, wraps ? 1.0f : 0.0f) << layers << " " << counter;
    }
  }
}

GPU_TEST(ShadowVolumes, FiniteVolumesLackWhatTheChordCutsOff) {
  // A caster that the light sees under 60 degrees, at a reach of 10: its far end lies flat at
  // 10 cos 30 = 8.66, a chord's 1.34 short of the sphere.
  const auto at = [](double height) {
    Scene scene;
    const uint32_t grey = add(scene, matte());
    addHorizontal(scene, grey, {0, -float(height), 0}, 4, 4);
    addHorizontal(scene, grey, {0, -1, 0}, float(std::tan(glm::radians(30.0))), 0.05f);
    Light light = pointLight({0, 0, 0}, 100);
    light.range = 10;
    addLight(scene, light);
    scene.cameras.push_back(lookAt({6, 2 - height, 1}, {0, -height, 0}));
    return scene;
  };
  const auto wrong = [&](double height, const char* extrusion) {
    Cell cell(cellDevice(device()), at(height), volumes({{"extrusion", extrusion}}));
    return shadowMismatch(cell).elsewhere;
  };
  for (const double height : {8.0, 8.6, 8.75, 9.5}) {
    EXPECT_EQ(wrong(height, "infinite"), 0u) << height;
    EXPECT_EQ(wrong(height, "finite") > 0, height > 10 * std::cos(glm::radians(30.0))) << height;
  }
  // Lights without a range reach all that there is.
  Cell cell(cellDevice(device()), stage(true), volumes({{"extrusion", "finite"}}));
  expectExact(cell, "finite", 300);
}

GPU_TEST(ShadowVolumes, OneCountForAllLightsIsAnApproximation) {
  Cell multi(cellDevice(device()), stage(true), volumes());
  Cell single(cellDevice(device()), stage(true),
              volumes({{"lights", "single"}, {"darkness", "0.75"}}));
  // In any light's shadow every light is a quarter of itself.
  for (size_t i = 0; i < size_t(96) * 64; ++i) {
    float least = 1;
    for (const uint32_t light : multi.renderer().lights())
      least = std::min(least, multi.visibility(light)[0][4 * i]);
    if (multi.visibility(0)[0][4 * i + 3] == 0) continue;
    for (const uint32_t light : single.renderer().lights())
      ASSERT_EQ(single.visibility(light)[0][4 * i], least == 0 ? 0.25f : 1.0f) << i;
  }
  EXPECT_GT(shadowMismatch(single).elsewhere, 1000u);
}
