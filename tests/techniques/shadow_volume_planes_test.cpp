// Shadow volumes of casters that near and far plane cut (spec 07: caps are the surface, to the last
// bit): wherever these planes are, what is lit stays lit, and what is in shadow stays dark.
#include "tests/techniques/shadow_volume_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

const std::vector<Setting> kSettings = {{},
                                        {{"count", "zfail"}},
                                        {{"counter", "float"}, {"count", "zfail"}},
                                        {{"sides", "one"}, {"count", "zfail"}},
                                        {{"build", "vertex"}, {"count", "zfail"}},
                                        {{"build", "geometry"}, {"count", "zfail"}},
                                        {{"build", "compute"}, {"count", "zfail"}}};

/// A wide floor with a box, under a light of its own.
Scene wideFloor(const Light& light) {
  Scene scene;
  const uint32_t grey = add(scene, matte());
  addHorizontal(scene, grey, {0, 0, 0}, 50, 50);
  addBox(scene, grey, {-1, 0.25f, -1}, {0, 1, 0});
  addLight(scene, light);
  return scene;
}

}  // namespace

GPU_TEST(ShadowVolumePlanes, FloorsThatEndAtTheFarPlaneAreLit) {
  for (const double far : {6.0, 12.0, 40.0})
    for (const Setting& setting : kSettings) {
      Scene scene = wideFloor(pointLight({0.5, 3, 0.25}, 20));
      scene.cameras.push_back(lookAt({0.5, 1.5, 4}, {0, 0.25, 0}, 1.0, far));
      Cell cell(cellDevice(device()), scene, volumes(setting));
      expectExact(cell, "far plane at " + std::to_string(far));
    }
}

GPU_TEST(ShadowVolumePlanes, FloorsBeforeTheNearPlaneOfParallelEyesAreLit) {
  for (const Light& light : {pointLight({0.5, 3, 0.25}, 20), sun({0.25, -1, 0.125})})
    for (const Setting& setting : kSettings) {
      Scene scene = wideFloor(light);
      Camera camera = lookAt({3, 1.5, 2.5}, {-0.5, 0.5, -0.25});
      camera.orthographic = true;
      camera.halfHeight = 2;
      camera.nearPlane = 1;
      scene.cameras.push_back(camera);
      Cell cell(cellDevice(device()), scene, volumes(setting));
      expectExact(cell, "near plane across the floor");
    }
}

GPU_TEST(ShadowVolumePlanes, CastersAcrossAndBeyondTheFarPlaneCast) {
  // A low sun behind a board that the far plane cuts and a box beyond it: their shadows reach the
  // eye.
  for (const Setting& setting : kSettings) {
    Scene scene = wideFloor(sun({0, -0.25, 1}));
    addQuad(scene, 0, {2, 0.75f, -5}, {0.5f, 0, -3}, {0, 0.5f, 0});
    addBox(scene, 0, {-3, 0, -8}, {-1.5f, 2.5f, -7});
    scene.cameras.push_back(lookAt({0, 1.5, 4}, {0, 0.25, 0}, 1.0, 9));
    Cell cell(cellDevice(device()), scene, volumes(setting));
    expectExact(cell, "across and beyond", 300);
  }
}

GPU_TEST(ShadowVolumePlanes, PartsAreDrawnOnlyWhereAPlaneCuts) {
  const auto draws = [&](double far) {
    Scene scene = wideFloor(pointLight({0.5, 3, 0.25}, 20));
    scene.cameras.push_back(lookAt({0.5, 1.5, 4}, {0, 0.25, 0}, 1.0, far));
    scene.cameras[0].nearPlane = 1e-3;
    Cell cell(cellDevice(device()), scene, volumes({{"count", "zfail"}}));
    for (const PassResult& pass : cell.result().passes)
      if (pass.label == "shadow volumes") return pass.counters.draws;
    return uint64_t(0);
  };
  // The floor reaches behind the eye, so it has caps at either end in both; the half beyond the far
  // plane is one more draw, of the floor that this plane cuts.
  EXPECT_EQ(draws(12), draws(400) + 1);
}
