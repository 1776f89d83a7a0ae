// The plan (design, section 3) on the null backend: an effect adds its passes, attachments and
// draws and nothing else, without it everything is as before; what cannot reach the view costs
// nothing; what a technique cannot represent is listed.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "backends/null/null_backend.h"
#include "suites/scenes/analysis/analysis.h"
#include "suites/scenes/procedural/shapes.h"
#include "techniques/render/registry.h"
#include "tests/techniques/cell.h"

namespace sb::test {
namespace {

using null_backend::Call;
using null_backend::CallKind;

struct Recorded {
  std::vector<Call> calls;  ///< of one frame
  FrameResult frame;
  std::map<std::string, uint64_t> bytes;
  Plan plan;
  size_t pipelines = 0;
};

Recorded record(const Scene& scene, const std::string& technique,
                std::map<std::string, std::string> knobs = {},
                const std::string& transparency = "Sorted") {
  const auto device = null_backend::makeBackend()->open({});
  Recorded r;
  {
    CellDevice shared(*device);
    Cell cell(shared, scene, {.technique = technique,
                               .knobs = std::move(knobs),
                               .transparency = transparency});
    null_backend::clearCalls(*device);
    cell.renderAgain();
    r = {null_backend::calls(*device), cell.result(), cell.renderer().bytesByLabel(),
         cell.renderer().plan(), shared.pipelines.size()};
  }
  EXPECT_TRUE(device->takeMessages().empty());
  return r;
}

Scene opaqueScene() {
  Scene scene = floorScene();
  scene.cameras[0] = lookAt({2, 3, 4}, {0, 0, 0});
  addBox(scene, 0, {-1, 0.25f, -1}, {0, 1, 0});
  return scene;
}

Scene withPane(Scene scene) {
  addHorizontal(scene, add(scene, glass(0.5f, {1, 0.5f, 0.25f})), {0, 1.5f, 0}, 0.5f, 0.5f);
  return scene;
}

std::vector<std::string> passes(const Recorded& r) {
  std::vector<std::string> labels;
  for (const PassResult& p : r.frame.passes) labels.push_back(p.label);
  return labels;
}

size_t draws(const Recorded& r, const std::string& pass) {
  return size_t(std::ranges::count_if(
      r.calls, [&](const Call& c) { return c.kind == CallKind::DrawIndexed && c.pass == pass; }));
}

/// Calls without the names of pipelines, which differ between techniques.
std::vector<Call> anonymous(std::vector<Call> calls) {
  for (Call& c : calls) c.pipeline.clear();
  return calls;
}

TEST(PlanOfPasses, OpaqueOnlyEveryTechniqueIsShadowMap) {
  const Recorded a = record(opaqueScene(), "ShadowMap", {{"compare", "manual"}});
  const Recorded b = record(opaqueScene(), "CSSM2");
  for (const char* technique : {"StochasticShadowMap", "CSSM1", "CSSM2"}) {
    const Recorded other = record(opaqueScene(), technique);
    EXPECT_EQ(anonymous(a.calls), anonymous(other.calls)) << technique;
    EXPECT_EQ(a.bytes, other.bytes) << technique;
    EXPECT_EQ(a.pipelines, other.pipelines) << technique;
  }
  EXPECT_EQ(passes(a), (std::vector<std::string>{"shadow map", "opaque"}));
  EXPECT_EQ(draws(a, "shadow map"), 2u);
  std::set<Effect> skipped;
  for (const auto& [effect, why] : b.plan.skipped) {
    EXPECT_FALSE(why.empty()) << effectName(effect);
    skipped.insert(effect);
  }
  EXPECT_TRUE(skipped.contains(Effect::TranslucentCasters));
  EXPECT_TRUE(skipped.contains(Effect::ColouredTransmission));
}

TEST(PlanOfPasses, APaneAddsItsOwnAndNothingElse) {
  const Recorded before = record(opaqueScene(), "CSSM2");
  const Recorded with = record(withPane(opaqueScene()), "CSSM2");
  EXPECT_EQ(passes(with), (std::vector<std::string>{"shadow map", "opaque", "translucent"}));
  EXPECT_EQ(draws(with, "shadow map"), draws(before, "shadow map") + 1);
  EXPECT_EQ(draws(with, "opaque"), draws(before, "opaque"));
  EXPECT_EQ(draws(with, "translucent"), 1u);
  std::set<std::string> added;
  for (const auto& [label, bytes] : with.bytes)
    if (!before.bytes.contains(label)) added.insert(label);
  EXPECT_EQ(added, std::set<std::string>{"shadow map colours"});
  EXPECT_EQ(with.bytes.at("shadow map colours"), 256u * 256u * 16u);
  EXPECT_EQ(with.pipelines, before.pipelines + 2);  // the pane for the light, and for the camera

  // Taken away again, everything is as before.
  Scene without = withPane(opaqueScene());
  without.instances.pop_back();
  const Recorded after = record(without, "CSSM2");
  EXPECT_EQ(before.calls, after.calls);
  EXPECT_EQ(before.frame.counters.draws, after.frame.counters.draws);
  EXPECT_EQ(before.pipelines, after.pipelines);
}

TEST(PlanOfPasses, APaneCostsAStochasticMapOneDrawAndNoPass) {
  for (const char* technique : {"StochasticShadowMap", "CSSM1"}) {
    const Recorded before = record(opaqueScene(), technique);
    const Recorded with = record(withPane(opaqueScene()), technique);
    EXPECT_EQ(passes(with), (std::vector<std::string>{"shadow map", "opaque", "translucent"}));
    EXPECT_EQ(draws(with, "shadow map"), draws(before, "shadow map") + 1) << technique;
    EXPECT_EQ(with.pipelines, before.pipelines + 2) << technique;
    // CSSM1 draws each triangle three times, into three layers.
    const uint64_t channels = std::string(technique) == "CSSM1" ? 3 : 1;
    EXPECT_EQ(with.bytes.at("shadow map depth"), channels * before.bytes.at("shadow map depth"));
    EXPECT_EQ(with.frame.passes[0].counters.triangles,
              channels * (before.frame.passes[0].counters.triangles + 2));
    EXPECT_EQ(with.bytes.size(), before.bytes.size()) << technique;
  }
}

TEST(PlanOfPasses, ThePaneCostsShadowMapOnlyItsPicture) {
  const Recorded before = record(opaqueScene(), "ShadowMap");
  const Recorded with = record(withPane(opaqueScene()), "ShadowMap");
  EXPECT_EQ(draws(with, "shadow map"), draws(before, "shadow map"));
  EXPECT_EQ(draws(with, "translucent"), 1u);
  const Recorded cast = record(withPane(opaqueScene()), "ShadowMap", {{"translucent", "opaque"}});
  EXPECT_EQ(draws(cast, "shadow map"), draws(before, "shadow map") + 1);
}

TEST(PlanOfPasses, WhatCannotReachTheViewCostsNothing) {
  const Recorded before = record(opaqueScene(), "CSSM2");
  Scene scene = opaqueScene();
  Light far = pointLight({0, 500, 0});
  far.range = 10;
  addLight(scene, far);                            // its range ends before the view
  addBox(scene, 0, {100, 5, 100}, {101, 6, 101});  // beside the light's path to the view
  addBox(scene, 0, {0, -60, 0}, {1, -59, 1});      // behind the floor, away from the light
  const Recorded with = record(scene, "CSSM2");
  EXPECT_EQ(before.calls, with.calls);
  EXPECT_EQ(before.frame.counters.draws, with.frame.counters.draws);
}

TEST(PlanOfPasses, LightsAddOnePassEachOrOneAFace) {
  Scene scene = opaqueScene();
  addLight(scene, spotLight({0, 4, 0}, {0, -1, 0}, 0.7));
  EXPECT_EQ(passes(record(scene, "ShadowMap")).size(), 3u);
  // From above, only the face that looks down and its neighbours meet casters.
  Scene point = opaqueScene();
  addLight(point, pointLight({0, 20, 0}));
  const size_t count = passes(record(point, "ShadowMap")).size();
  EXPECT_GE(count, 3u);
  EXPECT_LE(count, 7u);
  EXPECT_EQ(passes(record(opaqueScene(), "none")), std::vector<std::string>{"opaque"});
}

TEST(PlanOfPasses, NoLightOrNoCasterNoShadowPass) {
  Scene unlit = opaqueScene();
  unlit.lights.clear();
  for (const char* technique : {"none", "ShadowMap", "CSSM2"}) {
    const Recorded r = record(unlit, technique);
    EXPECT_EQ(passes(r), std::vector<std::string>{"opaque"}) << technique;
    EXPECT_FALSE(r.bytes.contains("shadow map depth")) << technique;
  }
}

TEST(PlanOfPasses, WhatIsNotRepresentedIsListed) {
  const Scene scene = withPane(opaqueScene());
  const auto has = [](const Recorded& r, Effect e) {
    return std::ranges::find(r.plan.unrepresented, e) != r.plan.unrepresented.end();
  };
  const Recorded none = record(scene, "none"), map = record(scene, "ShadowMap"),
                 cssm2 = record(scene, "CSSM2"), grey = record(scene, "StochasticShadowMap");
  EXPECT_FALSE(has(grey, Effect::TranslucentCasters));
  EXPECT_TRUE(has(grey, Effect::ColouredTransmission));
  EXPECT_TRUE(has(none, Effect::OpaqueCasters));
  EXPECT_TRUE(has(none, Effect::TranslucentCasters));
  EXPECT_FALSE(has(map, Effect::OpaqueCasters));
  EXPECT_TRUE(has(map, Effect::TranslucentCasters));
  EXPECT_TRUE(has(map, Effect::ColouredTransmission));
  EXPECT_TRUE(cssm2.plan.unrepresented.empty());
  Scene area = scene;
  area.lights[0].radius = 0.01;
  EXPECT_TRUE(has(record(area, "CSSM2"), Effect::AreaLights));
}

Scene greyScene() { return withPane(opaqueScene()); }

/// The same pane, which also transmits what the camera sees behind it.
Scene glassScene() {
  Scene scene = greyScene();
  scene.materials.back().transmission = 1;
  return scene;
}

TEST(PlanOfPasses, GlassIsPlannedOnlyWhereTheSceneCallsForIt) {
  for (const TransparencyEntry* entry : transparencyTechniques()) {
    const std::string& name = entry->info.name;
    SCOPED_TRACE(name);
    const Recorded grey = record(greyScene(), "CSSM2", {}, name);
    const Recorded glass = record(glassScene(), "CSSM2", {}, name);
    EXPECT_FALSE(grey.plan.runs(Effect::ColouredTransparency));
    EXPECT_TRUE(glass.plan.runs(Effect::ColouredTransparency));
    const auto why = std::ranges::find(grey.plan.skipped, Effect::ColouredTransparency,
                                       &std::pair<Effect, std::string>::first);
    ASSERT_NE(why, grey.plan.skipped.end());
    EXPECT_EQ(why->second, "no visible surface transmits what lies behind");

    // Glass that is not seen, glass taken away again: passes, draws, buffers and pipelines of before.
    Scene behind = greyScene();
    Material material = behind.materials.back();
    material.transmission = 1;
    addHorizontal(behind, add(behind, material), {40, 60, 80}, 0.5f, 0.5f);
    Scene without = glassScene();
    without.materials.back().transmission = 0;
    for (const Scene& scene : {behind, without}) {
      const Recorded other = record(scene, "CSSM2", {}, name);
      EXPECT_FALSE(other.plan.runs(Effect::ColouredTransparency));
      EXPECT_EQ(other.calls, grey.calls);
      EXPECT_EQ(other.pipelines, grey.pipelines);
      // An instance more has its place in the lists of the view, seen or not.
      auto bytes = other.bytes;
      for (const char* list : {"view draws", "view instances"})
        if (other.bytes.at(list) > grey.bytes.at(list)) bytes[list] = grey.bytes.at(list);
      EXPECT_EQ(bytes, grey.bytes);
    }
    // What has nothing to do with glass stays in a scene with it.
    for (const char* pass : {"shadow map", "opaque"}) {
      const auto ofPass = [&](const Recorded& r) {
        std::vector<Call> calls;
        std::ranges::copy_if(r.calls, std::back_inserter(calls),
                             [&](const Call& c) { return c.pass == pass; });
        return calls;
      };
      EXPECT_FALSE(ofPass(grey).empty());
      EXPECT_EQ(ofPass(grey), ofPass(glass)) << pass;
    }
  }
}

TEST(PlanOfPasses, GreyScenesDoWithoutTheShadersOfGlass) {
  rhi::ShaderLibrary grey;
  for (const auto& [name, code] : productionShaders())
    if (name.find("coloured") == name.npos) grey.add(code);
  ASSERT_LT(grey.size(), productionShaders().size());
  const auto device = null_backend::makeBackend()->open({});
  PipelineCache pipelines(*device);
  FrameQueries queries(*device);
  const auto render = [&](const Scene& scene, const TransparencyEntry& transparency) {
    const auto& shadows = shadowTechnique("CSSM2");
    const Effects effects = analyse(scene, 1);
    const GpuScene gpuScene(*device, scene);
    Renderer renderer({*device, grey, pipelines, queries}, gpuScene, effects,
                      {.technique = &shadows,
                       .transparency = &transparency,
                       .knobs = Knobs::resolve(knobsOf(shadows.info, transparency.info), {}),
                       .size = {64, 64},
                       .seed = 0,
                       .forced = {}});
    renderer.frame();
  };
  for (const TransparencyEntry* entry : transparencyTechniques()) {
    SCOPED_TRACE(entry->info.name);
    EXPECT_NO_THROW(render(greyScene(), *entry));
    EXPECT_THROW(render(glassScene(), *entry), rhi::Error);
  }
}

TEST(PlanOfPasses, GlassAddsToEachTechniqueWhatItNeedsAndNothingElse) {
  // What glass adds to and takes from grey, by technique.
  struct Change {
    std::set<std::string> grey, more;   ///< passes without glass, and what comes to them
    std::set<std::string> added, gone;  ///< memory, by label
  };
  const std::map<std::string, Change> changes = {
      {"Sorted", {{"opaque", "translucent"}, {}, {}, {}}},
      {"DepthPeeling",
       {{"opaque", "peel", "slide under", "composite"},
        {},
        {"peeled layer's weights", "coloured layers", "coloured transmittance"},
        {"peeled layers"}}},
      {"DualDepthPeeling",
       {{"opaque", "nearest and farthest", "peel both sides", "composite"},
        {"slide under", "lay over"},
        {"dual peeling front weights", "dual peeling back weights", "coloured layers",
         "coloured transmittance"},
        {}}},
      {"LinkedLists", {{"opaque", "lists", "sort and composite"}, {}, {"list nodes"}, {}}},
      {"StochasticTransparency",
       {{"opaque", "total opacity", "stochastic depth", "visible colours", "composite"},
        {},
        {"stochastic depths by channel", "total transmittance by channel", "stochastic light",
         "stochastic weights"},
        {"stochastic depths", "stochastic colours", "stochastic colours resolved",
         "total transmittance"}}},
  };
  for (const TransparencyEntry* entry : transparencyTechniques()) {
    const std::string& name = entry->info.name;
    SCOPED_TRACE(name);
    EXPECT_TRUE(changes.contains(name)) << "say here what glass adds to it";
    const Change change = changes.contains(name) ? changes.at(name) : Change{};
    // Queries find nothing on this backend.
    const auto& infos = entry->info.knobs;
    const bool stops = std::ranges::find(infos, "stop", &KnobInfo::name) != infos.end();
    std::map<std::string, std::string> knobs;
    if (stops) knobs["stop"] = "count";
    const Recorded grey = record(greyScene(), "none", knobs, name);
    const Recorded glass = record(glassScene(), "none", knobs, name);
    const auto beyond = [](const Recorded& a, const Recorded& b) {
      std::set<std::string> labels;
      for (const auto& [label, bytes] : a.bytes)
        if (!b.bytes.contains(label) || b.bytes.at(label) < bytes) labels.insert(label);
      return labels;
    };
    const auto all = [](const Recorded& r) {
      const auto labels = passes(r);
      return std::set<std::string>(labels.begin(), labels.end());
    };
    EXPECT_EQ(all(grey), change.grey);
    auto expected = change.grey;
    expected.insert(change.more.begin(), change.more.end());
    EXPECT_EQ(all(glass), expected);
    EXPECT_EQ(beyond(glass, grey), change.added);
    EXPECT_EQ(beyond(grey, glass), change.gone);
  }
}

TEST(Plan, GlassAddsWeightsPerChannelAndNothingElse) {
  const Scene grey = withPane(opaqueScene());
  Scene glassy = grey;
  glassy.materials.back().transmission = 1;
  const Recorded a = record(grey, "none"), b = record(glassy, "none");
  EXPECT_FALSE(a.plan.runs(Effect::ColouredTransparency));
  EXPECT_TRUE(b.plan.runs(Effect::ColouredTransparency));
  EXPECT_EQ(passes(a), passes(b));
  EXPECT_EQ(a.bytes, b.bytes) << "blending from two sources needs no target of its own";
  const auto why = std::ranges::find(a.plan.skipped, Effect::ColouredTransparency,
                                     &std::pair<Effect, std::string>::first);
  ASSERT_NE(why, a.plan.skipped.end());
  EXPECT_EQ(why->second, "no visible surface transmits what lies behind");
}

}  // namespace
}  // namespace sb::test
