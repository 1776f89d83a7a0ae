// Decision D8, worked by hand, and the classes that follow from it.
#include "techniques/scene/optics.h"

#include <gtest/gtest.h>

#include "techniques/plan/effects.h"

namespace sb {
namespace {

glm::vec3 tau(const Optics& o) { return glm::vec3(1) - o.alpha * (glm::vec3(1) - o.transmission); }

TEST(Optics, OpaqueBlocksAll) {
  Material m;
  const Optics o = optics(m, {.baseColor = {1, 1, 1, 0.3f}});
  EXPECT_EQ(tau(o), glm::vec3(0));
  EXPECT_EQ(o.alpha, 1);
  EXPECT_EQ(o.behind, glm::vec3(0));
}

TEST(Optics, MaskBlocksAtAndAboveTheCutoff) {
  Material m;
  m.alphaMode = AlphaMode::Mask;
  m.alphaCutoff = 0.5f;
  EXPECT_EQ(optics(m, {.baseColor = {1, 1, 1, 0.5f}}).alpha, 1);
  EXPECT_EQ(optics(m, {.baseColor = {1, 1, 1, 0.499f}}).alpha, 0);
  EXPECT_EQ(optics(m, {.baseColor = {1, 1, 1, 0.499f}}).behind, glm::vec3(1));
}

TEST(Optics, BlendLetsHalfItsColourThroughAndHidesGrey) {
  Material m;
  m.alphaMode = AlphaMode::Blend;
  const Optics o = optics(m, {.baseColor = {0, 0.5f, 1, 0.25f}});
  EXPECT_EQ(o.alpha, 0.25f);
  EXPECT_EQ(o.transmission, glm::vec3(0, 0.25f, 0.5f));
  EXPECT_EQ(tau(o), glm::vec3(0.75f, 0.8125f, 0.875f));
  EXPECT_EQ(o.behind, glm::vec3(0.75f));
}

TEST(Optics, TransmissionTimesColourForLightAndCamera) {
  Material m;
  m.transmission = 0.75f;
  const Optics o = optics(m, {.baseColor = {1, 0.5f, 0, 1}, .transmission = 0.75f});
  EXPECT_EQ(o.alpha, 1);
  EXPECT_EQ(o.transmission, glm::vec3(0.75f, 0.375f, 0));
  EXPECT_EQ(o.behind, o.transmission);
  m.alphaMode = AlphaMode::Mask;
  EXPECT_EQ(optics(m, {.baseColor = {1, 1, 1, 0}, .transmission = 0.75f}).alpha, 0);
}

TEST(Optics, AClosedMeshAbsorbsItsThicknessOnceAtTwoBoundaries) {
  Material m;
  m.transmission = 1;
  m.attenuationColor = {0.25f, 0.5f, 1};
  m.attenuationDistance = 2;
  const glm::vec3 t = optics(m, {.transmission = 1, .thickness = 2}).transmission;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(t[c] * t[c], m.attenuationColor[c], 1e-6);
  EXPECT_EQ(optics(m, {.transmission = 1}).transmission, glm::vec3(1)) << "thin";
}

TEST(Optics, MetalsDoNotTransmit) {
  Material m;
  m.transmission = 1;
  const Optics metal = optics(m, {.metallic = 1, .transmission = 1});
  EXPECT_EQ(tau(metal), glm::vec3(0));
  EXPECT_EQ(metal.behind, glm::vec3(0));
  EXPECT_EQ(tau(optics(m, {.metallic = 0.5f, .transmission = 1})), glm::vec3(0.5f));
}

TEST(Optics, AlphaOfBlendIsCoverageBesideTransmission) {
  Material m;
  m.alphaMode = AlphaMode::Blend;
  m.transmission = 1;
  const Optics o = optics(m, {.baseColor = {1, 0, 0, 0.25f}, .transmission = 1});
  EXPECT_EQ(tau(o), glm::vec3(1, 0.75f, 0.75f));
  EXPECT_EQ(o.behind, glm::vec3(1, 0.75f, 0.75f));
}

TEST(Optics, ExtrasStateThemOutright) {
  Material m;
  m.opticsOverride = true;
  m.overrideAlpha = 0.5f;
  m.overrideTransmission = {1, 0, 0};
  Optics o = optics(m, {.baseColor = {0, 0, 0, 1}});
  EXPECT_EQ(tau(o), glm::vec3(1, 0.5f, 0.5f));
  EXPECT_EQ(o.behind, glm::vec3(0.5f));
  m.transmission = 1;
  o = optics(m, {.baseColor = {0, 0, 0, 1}, .metallic = 1, .transmission = 1});
  EXPECT_EQ(o.behind, glm::vec3(1, 0.5f, 0.5f)) << "glass is seen through by its colour";
}

// A scene of one material and one textureless triangle of it.
Scene sceneOf(const Material& m) {
  Scene scene;
  scene.materials = {m};
  scene.meshes.emplace_back().positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  return scene;
}
MaterialTraits traits(const Scene& scene) { return materialTraits(scene, scene.materials[0]); }

TEST(MaterialTraits, Classes) {
  Material m;
  EXPECT_EQ(traits(sceneOf(m)).lightClass, MaterialClass::Opaque);
  m.alphaMode = AlphaMode::Mask;
  EXPECT_EQ(traits(sceneOf(m)).lightClass, MaterialClass::Opaque);  // alpha is 1 everywhere
  m.baseColor.a = 0.2f;
  EXPECT_EQ(traits(sceneOf(m)).lightClass, MaterialClass::Perforated);
  EXPECT_FALSE(traits(sceneOf(m)).cameraTranslucent);
  m.alphaMode = AlphaMode::Blend;
  EXPECT_EQ(traits(sceneOf(m)).lightClass, MaterialClass::Translucent);
  EXPECT_TRUE(traits(sceneOf(m)).cameraTranslucent);
  EXPECT_FALSE(traits(sceneOf(m)).coloured);
  m.baseColor = {0, 0, 0, 1};
  EXPECT_EQ(traits(sceneOf(m)).lightClass, MaterialClass::Opaque);  // alpha 1, t 0
  m.baseColor = {0, 0, 1, 0.5f};
  EXPECT_TRUE(traits(sceneOf(m)).coloured);
  EXPECT_FALSE(traits(sceneOf(m)).textured);
}

TEST(MaterialTraits, GlassMetalAndBlackGlass) {
  Material m;
  m.transmission = 1;
  m.metallic = 0;
  EXPECT_EQ(traits(sceneOf(m)).lightClass, MaterialClass::Translucent);
  EXPECT_TRUE(traits(sceneOf(m)).cameraTranslucent && traits(sceneOf(m)).cameraColoured);
  Material metal = m, black = m;
  metal.metallic = 1;
  black.baseColor = {0, 0, 0, 1};
  for (Material& none : {std::ref(metal), std::ref(black)}) {
    EXPECT_EQ(traits(sceneOf(none)).lightClass, MaterialClass::Opaque);
    EXPECT_FALSE(traits(sceneOf(none)).cameraTranslucent || traits(sceneOf(none)).cameraColoured);
    none.alphaMode = AlphaMode::Blend;
    none.baseColor.a = 0.5f;
    EXPECT_EQ(traits(sceneOf(none)).lightClass, MaterialClass::Translucent);
    EXPECT_TRUE(traits(sceneOf(none)).cameraTranslucent);
    EXPECT_FALSE(traits(sceneOf(none)).cameraColoured);
  }
  m.opticsOverride = true;
  m.overrideAlpha = 0.5f;
  m.overrideTransmission = {1, 0, 0};
  EXPECT_TRUE(traits(sceneOf(m)).cameraColoured);
  m.transmission = 0;
  EXPECT_FALSE(traits(sceneOf(m)).cameraColoured) << "procedural scenes stay grey to the camera";
}

TEST(MaterialTraits, TexelsAndVertexColoursCount) {
  Material m;
  m.alphaMode = AlphaMode::Blend;
  m.baseColor.a = 0.5f;
  m.baseColorTexture.image = 0;
  Scene scene = sceneOf(m);
  scene.images = {{"grey", 2, 1, {9, 9, 9, 255, 9, 9, 9, 255}}};
  EXPECT_FALSE(traits(scene).textured);
  scene.images[0].rgba[7] = 0;
  EXPECT_TRUE(traits(scene).textured);
  EXPECT_FALSE(traits(scene).coloured);
  scene.images[0].rgba[0] = 200;
  EXPECT_TRUE(traits(scene).coloured);
  scene = sceneOf(m);
  scene.materials[0].baseColorTexture = {};
  scene.meshes[0].colors = {{1, 1, 1, 1}, {1, 0, 1, 1}, {1, 1, 1, 1}};
  EXPECT_TRUE(traits(scene).coloured);
  EXPECT_TRUE(traits(scene).textured);
}

TEST(Effects, NamesAndSets) {
  EXPECT_EQ(effectName(Effect::OpaqueCasters), "opaque-casters");
  EXPECT_EQ(effectName(Effect::Emission), "emission");
  for (size_t i = 0; i < kEffectCount; ++i) EXPECT_FALSE(effectName(Effect(i)).empty());
  EffectSet set{Effect::AreaLights, Effect::OpaqueCasters};
  EXPECT_EQ(set.list(), (std::vector<Effect>{Effect::OpaqueCasters, Effect::AreaLights}));
}

}  // namespace
}  // namespace sb
