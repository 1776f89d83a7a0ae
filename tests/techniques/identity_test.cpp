// Decision D3 and the plan's proof on the drivers: without translucent casters the stochastic maps
// are ShadowMap at the same kernel with manual comparison, bit by bit and pass by pass; effects
// that a scene does not call for change nothing when they are forced (index 00, skip planner).
#include "suites/scenes/procedural/parts/shapes.h"
#include "tests/techniques/gpu_cell.h"

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

const std::vector<std::string> kStochastic = {"StochasticShadowMap", "CSSM1", "CSSM2"};

CellOptions stochastic(const std::string& technique, EffectSet forced = {}) {
  return {.technique = technique, .knobs = {{"kernel", "3"}}, .size = {96, 64}, .forced = forced};
}

void expectShadowMap(CellDevice& device, const std::string& technique) {
  Cell a(device, opaqueOnly(), manual());
  Cell b(device, opaqueOnly(), stochastic(technique));
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
  CellDevice fresh(device.device), other(device.device);
  Cell(fresh, opaqueOnly(), manual());
  Cell(other, opaqueOnly(), stochastic(technique));
  EXPECT_EQ(fresh.pipelines.size(), other.pipelines.size());
}

}  // namespace

GPU_TEST(Identity, OpaqueOnlyStochasticMapsAreShadowMap) {
  for (const std::string& technique : kStochastic) {
    SCOPED_TRACE(technique);
    expectShadowMap(cellDevice(device()), technique);
  }
}

GPU_TEST(Identity, DefaultsDifferByTheKernelAlone) {
  // Nothing but what a technique is may tell them apart: not comparison, bias or filter.
  for (const char* kernel : {"1", "9"}) {
    Cell a(cellDevice(device()), opaqueOnly(), {.knobs = {{"kernel", kernel}}, .size = {96, 64}});
    for (const char* technique :
         {"TranslucentShadows", "CompositedTranslucent", "StochasticShadowMap", "CSSM1", "CSSM2"}) {
      Cell b(cellDevice(device()), opaqueOnly(),
             {.technique = technique, .knobs = {{"kernel", kernel}}, .size = {96, 64}});
      EXPECT_EQ(a.picture().rgba, b.picture().rgba) << technique << " " << kernel;
    }
  }
}

GPU_TEST(Identity, HardwareComparisonIsShadowMapsToo) {
  CellOptions reference = manual();
  reference.knobs["compare"] = "hardware";
  Cell a(cellDevice(device()), opaqueOnly(), reference);
  for (const char* technique : {"StochasticShadowMap", "CSSM1"}) {
    CellOptions options = stochastic(technique);
    options.knobs["compare"] = "hardware";
    Cell b(cellDevice(device()), opaqueOnly(), options);
    EXPECT_EQ(a.picture().rgba, b.picture().rgba) << technique;
  }
}

GPU_TEST(Identity, ForcedEffectsLeaveThePictureAlone) {
  std::vector<std::string> techniques = kStochastic;
  techniques.push_back("ShadowMap");
  for (const std::string& technique : techniques) {
    const auto options = [&](EffectSet forced) {
      return technique == "ShadowMap" ? manual(forced) : stochastic(technique, forced);
    };
    Cell plain(cellDevice(device()), opaqueOnly(), options({}));
    const auto picture = plain.picture().rgba;
    EffectSet everything;
    for (size_t e = 0; e < kEffectCount; ++e) everything.add(Effect(e));
    for (const EffectSet forced :
         {EffectSet{Effect::TranslucentCasters}, EffectSet{Effect::NormalMaps},
          EffectSet{Effect::CameraTransparency, Effect::CameraLayers}, everything}) {
      Cell cell(cellDevice(device()), opaqueOnly(), options(forced));
      EXPECT_EQ(picture, cell.picture().rgba) << technique;
      const bool translucent = technique != "ShadowMap" && forced.has(Effect::TranslucentCasters);
      EXPECT_EQ(cell.hasMap("colours"), translucent && technique == "CSSM2");
      EXPECT_EQ(cell.renderer().plan().forced.has(Effect::TranslucentCasters), translucent);
      // Forced, CSSM1 draws into three layers a view: the memory says that it was executed.
      const auto bytes = cell.renderer().bytesByLabel().at("shadow map depth");
      EXPECT_EQ(bytes, plain.renderer().bytesByLabel().at("shadow map depth") *
                           (translucent && technique == "CSSM1" ? 3 : 1));
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
    Cell a(cellDevice(device()), near, coloured ? stochastic("CSSM2") : manual());
    Cell b(cellDevice(device()), more, coloured ? stochastic("CSSM2") : manual());
    EXPECT_EQ(a.result().counters.draws, b.result().counters.draws);
    EXPECT_EQ(a.result().passes.size(), b.result().passes.size());
    EXPECT_EQ(a.picture().rgba, b.picture().rgba);
  }
}
