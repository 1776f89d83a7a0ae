// Scenes in motion without a driver: what is written in which frame, and that frames allocate and
// upload nothing; light views along a path keep their places, and stable ones their texels.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "backends/null/null_backend.h"
#include "suites/scenes/analysis/analysis.h"
#include "techniques/draw/fit/view_path.h"
#include "tests/techniques/motion_scenes.h"

namespace sb::test {
namespace {

/// Counts what frames do beside drawing.
class Traffic final : public rhi::Observer {
 public:
  void created(rhi::BufferId id, const rhi::BufferDesc& desc) override {
    ++objects;
    labels[id.value] = desc.label;
  }
  void created(rhi::TextureId, const rhi::TextureDesc&) override { ++objects; }
  void created(rhi::PipelineId, const rhi::GraphicsPipelineDesc&) override { ++objects; }
  void write(rhi::BufferId id, uint64_t, uint64_t size) override {
    writes += size;
    byLabel[labels[id.value]] += size;
  }
  void upload(rhi::BufferId, uint64_t, uint64_t size) override { uploads += size; }
  uint64_t objects = 0, writes = 0, uploads = 0;
  std::map<std::string, uint64_t> byLabel;  ///< bytes written
  std::map<uint32_t, std::string> labels;
};

struct Watched {
  Watched(const Scene& scene, const CellOptions& options)
      : device(null_backend::makeBackend()->open({})) {
    device->setObserver(&traffic);
    shared = std::make_unique<CellDevice>(*device);
    cell = std::make_unique<Cell>(*shared, scene, options);
  }
  /// Of one more frame.
  Traffic frame() {
    traffic.objects = traffic.writes = traffic.uploads = 0;
    traffic.byLabel.clear();
    cell->renderAgain();
    return traffic;
  }
  Traffic traffic;
  std::unique_ptr<rhi::Device> device;
  std::unique_ptr<CellDevice> shared;
  std::unique_ptr<Cell> cell;
};

/// Knobs under which a technique has most to do when something moves.
std::map<std::string, std::string> busyKnobs(const std::string& technique) {
  if (technique == "TranslucentShadows") return {{"variant", "published"}, {"order", "triangle"}};
  if (technique == "CompositedTranslucent") return {{"partition", "batches"}};
  return {};
}

TEST(Motion, FramesWriteThroughTheirCommandsAndAllocateNothing) {
  for (const ShadowEntry* technique : shadowTechniques()) {
    const std::string& name = technique->info.name;
    for (const Scene& scene :
         {travelled(true), inhabited(true), inhabited(true, true), restless()}) {
      Watched moving(scene, {.technique = name, .knobs = busyKnobs(name)});
      for (uint32_t k = 1; k < 12; ++k) {
        const Traffic t = moving.frame();
        EXPECT_GT(t.writes, 1000u) << name;
        EXPECT_EQ(t.uploads, 0u) << name;
        EXPECT_EQ(t.objects, 0u) << name;
      }
    }
  }
}

TEST(Motion, OnlyWhatMovesIsWritten) {
  const uint64_t record = sizeof(gpu::InstanceData),
                 all = record * furnished(true).instances.size();
  const auto written = [](const Scene& scene) {
    return Watched(scene, {.technique = "ShadowMap"}).frame().byLabel;
  };
  Scene one = furnished(true), two = one, light = one;
  shift(one, 3, {{1, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(written(one)["view instances"], record);
  EXPECT_GT(written(one)["view shadow views"], 0u) << "receivers and casters moved";
  // Neighbours are written at once, others apart.
  for (const uint32_t i : {3u, 4u, 7u}) shift(two, i, {{1, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(written(two)["view instances"], 3 * record);
  LightPose pose{light.lights[1].position, light.lights[1].direction, light.lights[1].halfAxes};
  LightPose lower = pose;
  lower.position.y -= 0.5;
  moveLight(light, 1, std::vector{pose, lower});
  EXPECT_FALSE(written(light).contains("view instances"));
  EXPECT_GT(written(light)["view lights"], 0u);
  EXPECT_EQ(written(travelled(true))["view instances"], all) << "all are relative to the eye";
}

TEST(Motion, AStandingSceneWritesNothing) {
  for (const ShadowEntry* technique : shadowTechniques()) {
    const std::string& name = technique->info.name;
    const Scene scene = restless();
    Watched standing(standingAt(scene, 4), {.technique = name, .knobs = busyKnobs(name)});
    Watched stopped(scene, {.technique = name, .knobs = busyKnobs(name)});
    stopped.cell->standAt(4);
    for (Watched* watched : {&standing, &stopped}) {
      const Traffic t = watched->frame();
      EXPECT_EQ(t.writes + t.uploads + t.objects, 0u) << name;
      for (const PassResult& pass : watched->cell->result().passes)
        EXPECT_NE(pass.label, "moved") << name;
    }
  }
}

TEST(Motion, MovingIsPartOfTheFrameUnderItsName) {
  Watched moving(travelled(true), {.technique = "CSSM2"});
  const FrameResult& frame = moving.cell->result();
  ASSERT_FALSE(frame.passes.empty());
  EXPECT_EQ(frame.passes.front().label, "moved");
  EXPECT_EQ(frame.passes.size(), frame.counters.passes + 1);
  const FrameResult stamped = moving.cell->renderer().frame(FrameMode::Stamped);
  for (const PassResult& pass : stamped.passes) EXPECT_TRUE(pass.ms.has_value()) << pass.label;
}

TEST(Motion, DrawsAreThoseOfAStandingSceneAtEachStep) {
  // What only other steps show or need costs a step nothing.
  for (const Scene& scene : {travelled(true), inhabited(true), restless()}) {
    Watched moving(scene, {.technique = "CSSM2"});
    std::set<uint64_t> passes;
    for (uint32_t k = 0; k < scene.path.size(); ++k) {
      Watched still(standingAt(scene, k), {.technique = "CSSM2"});
      const rhi::Counters &a = moving.cell->result().counters, &b = still.cell->result().counters;
      EXPECT_EQ(a, b) << k << ": " << a.passes << " " << a.draws << ", " << b.passes << " "
                      << b.draws;
      passes.insert(a.passes);
      moving.cell->renderAgain();
    }
    EXPECT_GT(passes.size(), 1u) << "all steps are alike";
  }
}

TEST(Motion, ALightThatCirclesWritesOtherLayersAtEachStep) {
  // A point light that goes round a pillar on a plate: another of its faces sees them each time.
  Scene scene;
  addHorizontal(scene, add(scene, matte()), {0, 0, 0}, 0.75f, 0.75f);
  addBox(scene, add(scene, matte()), {-0.5f, 0, -0.5f}, {0.5f, 2, 0.5f});
  addLight(scene, pointLight({3, 1, 0}, 4));
  scene.cameras.push_back(lookAt({0, 6, 6}, {0, 0, 0}));
  std::vector<LightPose> poses;
  for (const glm::dvec3 at : {glm::dvec3(3, 1, 0), {0, 1, 3}, {-3, 1, 0}, {0, 1, -3}})
    poses.push_back({at, {0, -1, 0}, glm::dmat3(0)});
  moveLight(scene, 0, poses);
  Watched moving(scene, {.technique = "ShadowMap"});
  std::set<std::set<int>> written;
  for (uint32_t k = 0; k < 4; ++k) {
    std::set<int> layers;
    for (const LightView& view : moving.cell->renderer().view().lightViews())
      if (view.layer >= 0) layers.insert(view.layer);
    size_t passes = 0;
    for (const PassResult& pass : moving.cell->result().passes)
      passes += pass.label == "shadow map";
    EXPECT_EQ(passes, layers.size()) << k;
    written.insert(layers);
    moving.cell->renderAgain();
  }
  EXPECT_EQ(written.size(), 4u);
}

LightView viewOf(uint32_t light, uint32_t face, std::vector<uint32_t> opaque) {
  LightView view{.light = light, .face = face, .opaque = std::move(opaque)};
  view.origin = {float(10 * light + face), 0, 0};
  return view;
}

TEST(Motion, ViewsKeepTheirPlacesAlongAPath) {
  const std::vector<std::vector<LightView>> steps = {
      {viewOf(0, 0, {1}), viewOf(2, 0, {}), viewOf(2, 1, {7})},
      {viewOf(1, 0, {3, 5}), viewOf(2, 0, {}), viewOf(2, 1, {4})}};
  const std::vector<LightView> united = uniteViews(steps);
  ASSERT_EQ(united.size(), 4u);
  EXPECT_EQ(united[3].opaque, (std::vector<uint32_t>{4, 7}));
  const auto layers = [](const std::vector<LightView>& views) {
    std::vector<int> out;
    for (const LightView& v : views) out.push_back(v.layer);
    return out;
  };
  EXPECT_EQ(layers(united), (std::vector<int>{0, 1, -1, 2}));
  const std::vector<LightView> second = placeViews(united, steps[1]);
  EXPECT_EQ(layers(second), (std::vector<int>{-1, 1, -1, 2}));
  EXPECT_EQ(second[1].opaque, (std::vector<uint32_t>{3, 5}));
  EXPECT_EQ(second[3].opaque, (std::vector<uint32_t>{4}));
  EXPECT_TRUE(second[0].empty());
}

TEST(Motion, StableFitsKeepTheirTexelsAlongAPath) {
  Scene scene = furnished(false);
  moveCamera(scene,
             cameraPath(scene.camera().toWorld, {-0.37, 2.111, 5.3}, 90, 33));  // no round numbers
  const Effects effects = analyse(scene, 1);
  const LightFitSettings settings{.mapSize = 256, .guardTexels = 3, .fit = LightFit::Stable};
  const auto fit = [&](uint32_t k) {
    return fitLights(PlacedScene(scene, k), effects.steps[k], 1, settings).at(0);
  };
  const LightView last = fit(32);
  for (uint32_t k = 0; k < 32; ++k) {
    const LightView view = fit(k);
    EXPECT_EQ(view.texelWidth, last.texelWidth) << k;
    for (int row = 0; row < 2; ++row)  // width on the map, not depth
      for (int c = 0; c < 3; ++c) EXPECT_EQ(view.toClip[c][row], last.toClip[c][row]);
    // The window moves by whole texels.
    const glm::dvec3 moved = glm::dvec3(view.origin) + PlacedScene(scene, k).camera().eye() -
                             glm::dvec3(last.origin) - scene.camera().eye();
    const glm::dmat4 m(view.toClip);
    for (int row = 0; row < 2; ++row) {
      const double texels = 128 * glm::dot(glm::dvec3(m[0][row], m[1][row], m[2][row]), moved);
      EXPECT_NEAR(texels, std::round(texels), 2e-3) << k;
    }
  }
}

}  // namespace
}  // namespace sb::test
