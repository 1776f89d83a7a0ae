// Decision D3 and the plan's proof on the drivers: without translucent casters CSSM2 is ShadowMap
// at the same kernel with manual comparison, bit by bit and pass by pass; effects that a scene does
// not call for change nothing when they are forced (index 00, skip planner).
#include "tests/techniques/gpu_cell.h"
#include "suites/scenes/shapes.h"

using namespace sb;
using namespace sb::test;

namespace {

Scene opaqueOnly() {
  Scene scene = floorScene();
  scene.cameras[0] = lookAt({2, 3, 4}, {0, 0, 0});
  addBox(scene, 0, {-1, 0.25f, -1}, {0, 1, 0});
  addBox(scene, 0, {0.5f, 0, 0.5f}, {1, 2, 1});
  scene.lights[0] = sun({0.5, -1, 0.25});
  addLight(scene, pointLight({1.5, 2, -1}, 4));
  addLight(scene, spotLight({-2, 3, 1}, {0.5, -1, -0.25}, 0.75, 6));
  return scene;
}

CellOptions manual(EffectSet forced = {}) {
  return {.technique = "ShadowMap",
          .knobs = {{"compare", "manual"}, {"kernel", "3"}},
          .size = {96, 64},
          .forced = forced};
}

CellOptions cssm2(EffectSet forced = {}) {
  return {.technique = "CSSM2", .knobs = {{"kernel", "3"}}, .size = {96, 64}, .forced = forced};
}

}  // namespace

GPU_TEST(Identity, OpaqueOnlyCssm2IsShadowMap) {
  Cell a(cellDevice(device()), opaqueOnly(), manual());
  Cell b(cellDevice(device()), opaqueOnly(), cssm2());
  EXPECT_EQ(a.picture().rgba, b.picture().rgba);
  for (uint32_t light = 0; light < 3; ++light) EXPECT_EQ(a.visibility(light), b.visibility(light));
  EXPECT_FALSE(b.hasMap("colours"));
  for (uint32_t layer = 0; layer < 3; ++layer)
    EXPECT_EQ(a.map("depth", layer), b.map("depth", layer));
  const auto &p = a.result().passes, &q = b.result().passes;
  ASSERT_EQ(p.size(), q.size());
  EXPECT_GT(p.size(), 3u);
  for (size_t i = 0; i < p.size(); ++i) {
    EXPECT_EQ(p[i].label, q[i].label);
    EXPECT_EQ(p[i].counters.draws, q[i].counters.draws);
    EXPECT_EQ(p[i].counters.triangles, q[i].counters.triangles);
  }
  EXPECT_EQ(a.renderer().bytesByLabel(), b.renderer().bytesByLabel());
  // The same number of pipelines, each made afresh.
  CellDevice fresh(device()), other(device());
  Cell(fresh, opaqueOnly(), manual());
  Cell(other, opaqueOnly(), cssm2());
  EXPECT_EQ(fresh.pipelines.size(), other.pipelines.size());
}

GPU_TEST(Identity, ForcedEffectsLeaveThePictureAlone) {
  for (const bool coloured : {false, true}) {
    const auto options = [&](EffectSet forced) {
      return coloured ? cssm2(forced) : manual(forced);
    };
    Cell plain(cellDevice(device()), opaqueOnly(), options({}));
    const auto picture = plain.picture().rgba;
    EffectSet everything;
    for (size_t e = 0; e < kEffectCount; ++e) everything.add(Effect(e));
    for (const EffectSet forced :
         {EffectSet{Effect::TranslucentCasters}, EffectSet{Effect::NormalMaps},
          EffectSet{Effect::CameraTransparency, Effect::CameraLayers}, everything}) {
      Cell cell(cellDevice(device()), opaqueOnly(), options(forced));
      EXPECT_EQ(picture, cell.picture().rgba) << coloured;
      const bool colours = coloured && forced.has(Effect::TranslucentCasters);
      EXPECT_EQ(cell.hasMap("colours"), colours);
      EXPECT_EQ(cell.renderer().plan().forced.has(Effect::TranslucentCasters), colours);
    }
  }
}

GPU_TEST(Identity, LightsAndCastersOutOfReachLeaveThePictureAlone) {
  Scene near = opaqueOnly(), more = opaqueOnly();
  Light far = pointLight({0, 500, 0}, 1e6f);
  far.range = 10;
  addLight(more, far);
  addBox(more, 0, {100, -50, 100}, {101, -49, 101});
  for (const bool coloured : {false, true}) {
    Cell a(cellDevice(device()), near, coloured ? cssm2() : manual());
    Cell b(cellDevice(device()), more, coloured ? cssm2() : manual());
    EXPECT_EQ(a.result().counters.draws, b.result().counters.draws);
    EXPECT_EQ(a.result().passes.size(), b.result().passes.size());
    EXPECT_EQ(a.picture().rgba, b.picture().rgba);
  }
}
