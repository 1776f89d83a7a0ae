// The passes of penumbra wedges: two a light in the default, all wedges in one draw; nothing where
// no light has an extent.
#include "techniques/scene/light_area.h"
#include "tests/techniques/recorded.h"

namespace sb::test {
namespace {

/// Three boxes over a floor, a lamp.
Scene boxesUnderLamp(double radius) {
  Scene scene = opaqueScene();
  addBox(scene, 0, {0.5f, 0.25f, 0.5f}, {1, 1, 1});
  addBox(scene, 0, {0.5f, 0.25f, -1}, {1, 1, -0.5f});
  scene.lights.clear();
  Light lamp = pointLight({0, 4, 0});
  makeSphere(lamp, radius);
  addLight(scene, lamp);
  return scene;
}

TEST(PenumbraPasses, AllWedgesOfALightAreOneDraw) {
  const Recorded r = record(boxesUnderLamp(0.5), "PenumbraWedge");
  EXPECT_EQ(passes(r), (std::vector<std::string>{"depth prepass", "penumbra wedges", "shadow mask",
                                                 "opaque"}));
  const Recorded hard = record(boxesUnderLamp(0), "StencilShadowVolume");
  EXPECT_EQ(draws(r, "penumbra wedges"), draws(hard, "shadow volumes") + 1);
  EXPECT_TRUE(r.plan.runs(Effect::AreaLights));
  EXPECT_TRUE(r.plan.unrepresented.empty());
  EXPECT_GT(r.bytes.at("penumbra wedges"), 0u);
}

TEST(PenumbraPasses, EachLightHasItsOwnAndHardOnesThoseOfVolumes) {
  Scene scene = boxesUnderLamp(0.5);
  addLight(scene, pointLight({1, 4, 0}));
  Light sunny = sun({0.25, -1, 0});
  sunny.angularRadius = 0.05;
  addLight(scene, sunny);
  EXPECT_EQ(
      passes(record(scene, "PenumbraWedge")),
      (std::vector<std::string>{"depth prepass", "penumbra wedges", "shadow mask", "shadow volumes",
                                "shadow mask", "penumbra wedges", "shadow mask", "opaque"}));
}

TEST(PenumbraPasses, WaysToCombineDiffer) {
  const auto labels = [](const char* combine) {
    return passes(record(boxesUnderLamp(0.5), "PenumbraWedge", {{"combine", combine}}));
  };
  EXPECT_EQ(labels("float"), labels("shader"));
  EXPECT_EQ(labels("exact"), (std::vector<std::string>{"depth prepass", "shadow mask", "opaque"}));
  const std::vector<std::string> wrap = labels("wrap");
  const auto casters = std::ranges::count(wrap, "penumbra wedges");
  EXPECT_GE(casters, 3) << "one a caster";
  EXPECT_EQ(std::ranges::count(wrap, "shadow mask"), casters);
}

TEST(PenumbraPasses, LoopsAreTwoPassesEachAndHalvesFourDrawsAWedge) {
  const Scene scene = boxesUnderLamp(0.5);
  const Recorded volumes = record(boxesUnderLamp(0), "StencilShadowVolume");
  // Three boxes and the floor, a loop each.
  const Recorded loop = record(scene, "PenumbraWedge", {{"combine", "loop"}});
  const std::vector<std::string> labels = passes(loop);
  EXPECT_EQ(std::ranges::count(labels, "penumbra wedges"), 4);
  EXPECT_EQ(std::ranges::count(labels, "shadow mask"), 4);
  EXPECT_EQ(draws(loop, "penumbra wedges"), draws(volumes, "shadow volumes") + 4);
  const Recorded split = record(scene, "PenumbraWedge", {{"combine", "split"}});
  EXPECT_EQ(passes(split), (std::vector<std::string>{"depth prepass", "penumbra wedges",
                                                     "shadow mask", "opaque"}));
  // The floor has four edges; the boxes that the lamp stands beside six, the one below it four.
  const uint32_t wedges = 4 + 4 + 6 + 6;
  EXPECT_EQ(draws(split, "penumbra wedges"), draws(volumes, "shadow volumes") + 4 * wedges);
}

TEST(PenumbraPasses, WithoutExtentNothingOfThemExists) {
  // A lamp so small that its penumbrae are narrower than a pixel has none either.
  for (const double radius : {0.0, 1e-4}) {
    Scene scene = floorScene();
    addHorizontal(scene, 0, {0.5, 1, 0}, 0.5f, 0.5f);
    scene.lights = boxesUnderLamp(radius).lights;
    const Recorded r = record(scene, "PenumbraWedge");
    const Recorded volumes = record(scene, "StencilShadowVolume");
    EXPECT_TRUE(anonymous(r.calls) == anonymous(volumes.calls)) << radius;
    EXPECT_EQ(r.bytes, volumes.bytes) << radius;
    EXPECT_EQ(r.pipelines, volumes.pipelines) << radius;
  }
}

}  // namespace
}  // namespace sb::test
