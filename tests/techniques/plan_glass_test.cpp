// Glass in the plan, on the null backend: weights per channel for what lies behind cost something
// where the scene calls for them, and nothing elsewhere, in every transparency technique.
#include <gtest/gtest.h>

#include <iterator>
#include <set>

#include "techniques/render/registry.h"
#include "tests/techniques/recorded.h"

namespace sb::test {
namespace {

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
      // An instance more has its place in the list of the view, seen or not.
      auto bytes = other.bytes;
      const char* list = "view instances";
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
    Stage stage(scene, {64, 64});
    const auto renderer = stage.renderer({*device, grey, pipelines, queries},
                                         rendererDesc({.technique = "CSSM2",
                                                       .transparency = transparency.info.name,
                                                       .width = 64,
                                                       .height = 64}));
    renderer->frame();
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
