// The plan (design, section 3) on the null backend: an effect adds its passes, attachments and
// draws and nothing else, without it everything is as before; what cannot reach the view costs
// nothing; what a technique cannot represent is listed.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "techniques/render/registry.h"
#include "tests/techniques/recorded.h"

namespace sb::test {
namespace {

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
  area.lights[0].angularRadius = 0.01;
  EXPECT_TRUE(has(record(area, "CSSM2"), Effect::AreaLights));
}

}  // namespace
}  // namespace sb::test
