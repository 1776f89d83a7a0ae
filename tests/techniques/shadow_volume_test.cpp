// Stencil shadow volumes (spec 07): exact to the pixel for any caster, any light and any eye; the
// same picture however they are built and counted.
#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/techniques/shadow_volume_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

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
    {{"build", "cpu"}}, {{"build", "vertex"}}, {{"build", "geometry"}}, {{"build", "compute"}}};

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
  for (const Setting& setting : std::vector<Setting>{{},
                                                     {{"count", "zfail"}},
                                                     {{"counter", "float"}},
                                                     {{"build", "vertex"}},
                                                     {{"build", "compute"}}}) {
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

GPU_TEST(ShadowVolumes, FarParallelEyesSeeVolumesThatEndBeforeThem) {
  // A lamp's reach ends between the box and the near plane; rays go through where the volume would
  // be, leave it and meet a floor that is lit.
  Scene scene;
  const uint32_t grey = add(scene, matte());
  addHorizontal(scene, grey, {0, -1.25f, 0}, 1.5f, 1.5f);
  addBox(scene, grey, {0.75f, -0.25f, -0.25f}, {1.25f, 0.25f, 0.25f});
  addBox(scene, grey, {-0.4f, -0.7f, -0.2f}, {-0.2f, -0.5f, 0.2f});
  Light lamp = pointLight({0, 0, 0}, 20);
  lamp.range = 2;
  addLight(scene, lamp);
  Camera camera = lookAt({9, 5, 0.5}, {0, -1.25, 0});
  camera.orthographic = true;
  camera.halfHeight = 1.5;
  scene.cameras.push_back(camera);
  for (const char* count : {"auto", "zpass", "zfail"}) {
    Cell cell(cellDevice(device()), scene, volumes({{"count", count}}));
    expectExact(cell, count);
  }
}

GPU_TEST(ShadowVolumes, ManyLightsHaveAChannelEach) {
  Scene scene = stage(true);
  for (const double x : {-2.0, -0.5, 1.0, 2.5}) addLight(scene, pointLight({x, 2.5, -1}, 2));
  Cell cell(cellDevice(device()), scene, volumes());
  ASSERT_EQ(cell.renderer().lights().size(), 7u);
  expectExact(cell, "seven lights", 300);
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
