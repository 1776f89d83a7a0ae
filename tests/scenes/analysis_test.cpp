// Each effect on and off, and that what is culled could not have mattered.
#include "suites/scenes/analysis/analysis.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "suites/scenes/analysis/describe.h"
#include "suites/scenes/edit/framing.h"
#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/scenes.h"
#include "techniques/scene/light_area.h"
#include "techniques/scene/placed_scene.h"

namespace sb {
namespace {

glm::dmat4 at(double x, double y, double z) {
  glm::dmat4 m(1);
  m[3] = {x, y, z, 1};
  return m;
}

/// A white floor at y = 0 under a camera that looks straight down at [-4,4]^2; light from above.
class AnalysisTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const uint32_t white = addMaterial(m_scene, matteMaterial("white", glm::vec3(1)));
    glm::dmat4 flat = at(0, 0, 0);
    flat[1] = {0, 0, -1, 0}, flat[2] = {0, 1, 0, 0};
    m_flat = flat;
    addInstance(m_scene, "floor", addMesh(m_scene, quadMesh("floor", white, glm::vec2(4))), flat);
    m_scene.lights.push_back(sunLight({0, -1, 0}, 0));
    Camera camera;
    camera.orthographic = true;
    camera.halfHeight = 4;
    camera.nearPlane = 0.5, camera.farPlane = 10.5;
    camera.toWorld = lookFrom({0, 10, 0}, {0, 0, 0});
    m_scene.cameras = {camera};
  }
  /// A horizontal quad of half size 0.5.
  uint32_t quad(Material material, double x, double y, double z) {
    const uint32_t m = addMaterial(m_scene, std::move(material));
    glm::dmat4 place = m_flat;
    place[3] = {x, y, z, 1};
    return addInstance(m_scene, "quad", addMesh(m_scene, quadMesh("quad", m, glm::vec2(0.5f))),
                       place);
  }
  Effects effects() const { return analyse(m_scene, 1); }
  bool has(Effect effect) const { return effects().present.has(effect); }

  Scene m_scene;
  glm::dmat4 m_flat;
};

TEST_F(AnalysisTest, APathCallsForWhatAnyOfItsStepsCallsFor) {
  const uint32_t pane = quad(paneMaterial("pane", glm::vec3(1), 0.5f), 6, 1, 0);  // beside the view
  const uint32_t near = quad(matteMaterial("near", glm::vec3(1)), 1, 1, 0);
  glm::dmat4 beside = m_scene.camera().toWorld;
  beside[3].x = 8;
  moveCamera(m_scene, std::vector{beside, m_scene.camera().toWorld});
  const Effects e = effects();
  ASSERT_EQ(e.steps.size(), 2u);
  EXPECT_EQ(e.steps[0].visibleTranslucent, (std::vector<uint32_t>{pane}));
  EXPECT_TRUE(e.steps[1].visibleTranslucent.empty());
  EXPECT_EQ(e.steps[0].visibleOpaque, std::vector<uint32_t>{0});
  EXPECT_EQ(e.visibleOpaque, (std::vector<uint32_t>{0, near}));
  EXPECT_EQ(e.visibleTranslucent, (std::vector<uint32_t>{pane}));
  EXPECT_EQ(e.lights[0].translucentCasters, (std::vector<uint32_t>{pane}));
  EXPECT_TRUE(e.present.has(Effect::CameraTransparency));
  EXPECT_EQ(e.reason.at(Effect::CameraTransparency),
            "along the path, in 1 of 2 steps: the camera sees through 1 instance");
  EXPECT_EQ(e.reason.at(Effect::NormalMaps),
            "nowhere along the path: no visible instance has a normal map");
  // The last step is the standing camera.
  m_scene.path.clear();
  const Effects still = effects();
  EXPECT_TRUE(still.steps.empty());
  EXPECT_EQ(still.visibleOpaque, e.steps[1].visibleOpaque);
  EXPECT_FALSE(still.present.has(Effect::CameraTransparency));
}

TEST_F(AnalysisTest, EveryEffectHasAReason) {
  const Effects e = effects();
  EXPECT_EQ(e.reason.size(), kEffectCount);
  for (const auto& [effect, reason] : e.reason) EXPECT_FALSE(reason.empty()) << effectName(effect);
  EXPECT_EQ(e.visibleOpaque, (std::vector<uint32_t>{0}));
  EXPECT_TRUE(e.lights.at(0).touchesView);
}

TEST_F(AnalysisTest, CastersByClass) {
  Material mask = matteMaterial("mask", glm::vec3(1));
  mask.alphaMode = AlphaMode::Mask;
  mask.baseColor.a = 0;
  EXPECT_FALSE(has(Effect::TranslucentCasters) || has(Effect::PerforatedCasters));
  quad(mask, 0, 1, 0);
  EXPECT_TRUE(has(Effect::PerforatedCasters));
  EXPECT_FALSE(has(Effect::TranslucentCasters));
  quad(paneMaterial("grey", glm::vec3(0.5f), 0.5f), 2, 1, 0);
  EXPECT_TRUE(has(Effect::TranslucentCasters));
  EXPECT_FALSE(has(Effect::ColouredTransmission) || has(Effect::TexturedTransmission));
  quad(paneMaterial("blue", {0, 0, 1}, 0.5f), -2, 1, 0);
  EXPECT_TRUE(has(Effect::ColouredTransmission));
  const Effects e = effects();
  EXPECT_EQ(e.lights[0].perforatedCasters, (std::vector<uint32_t>{1}));
  EXPECT_EQ(e.lights[0].translucentCasters, (std::vector<uint32_t>{2, 3}));
}

TEST_F(AnalysisTest, CastersOutsideTheViewCountOnlyIfTheirShadowsReachIt) {
  const uint32_t above = quad(matteMaterial("a", glm::vec3(1)), 0, 50, 0);  // behind the camera
  quad(matteMaterial("b", glm::vec3(1)), 20, 5, 0);                         // beside the view
  quad(matteMaterial("c", glm::vec3(1)), 0, -5, 0);                         // under the floor
  EXPECT_EQ(effects().lights[0].opaqueCasters, (std::vector<uint32_t>{0, above}));
  m_scene.lights[0].direction = glm::normalize(glm::dvec3(-4, -1, 0));
  EXPECT_EQ(effects().lights[0].opaqueCasters, (std::vector<uint32_t>{0, 2}));
}

TEST_F(AnalysisTest, AreaLightsWidenShadows) {
  quad(matteMaterial("a", glm::vec3(1)), 6, 5, 0);
  EXPECT_EQ(effects().lights[0].opaqueCasters.size(), 1u);
  EXPECT_FALSE(has(Effect::AreaLights));
  m_scene.lights[0].angularRadius = std::atan(0.4);  // 5 units down: 2 aside
  EXPECT_EQ(effects().lights[0].opaqueCasters.size(), 2u);
  EXPECT_TRUE(has(Effect::AreaLights));
}

TEST_F(AnalysisTest, LampsWithAnExtentReachAside) {
  // A board beside the view and the lamp: no ray from the floor to its centre meets it.
  Light& lamp = m_scene.lights[0];
  lamp.type = LightType::Point;
  lamp.position = {3.9, 6, 0};
  quad(matteMaterial("a", glm::vec3(1)), 5.6, 6, 0);
  EXPECT_EQ(effects().lights[0].opaqueCasters.size(), 1u);
  EXPECT_FALSE(has(Effect::AreaLights));
  lamp.shape = LightShape::Rectangle;
  lamp.halfAxes = glm::dmat3(glm::dvec3(1, 0, 0), glm::dvec3(0, 2, 0), glm::dvec3(0));
  EXPECT_EQ(effects().lights[0].opaqueCasters.size(), 2u);
  EXPECT_TRUE(has(Effect::AreaLights));
  // A sphere of radius 5.9 is seen as a disc that is several times as large from where it is near.
  lamp.halfAxes = glm::dmat3(0);
  makeSphere(lamp, 1);
  EXPECT_EQ(effects().lights[0].opaqueCasters.size(), 1u);
  makeSphere(lamp, 5.9);
  quad(matteMaterial("b", glm::vec3(1)), 25, 6, 0);
  EXPECT_EQ(effects().lights[0].opaqueCasters.size(), 3u);
}

TEST_F(AnalysisTest, OverlapNeedsTwoPanesInLine) {
  const Material grey = paneMaterial("grey", glm::vec3(0.5f), 0.5f);
  quad(grey, 0, 1, 0);
  EXPECT_TRUE(has(Effect::TranslucentReceivers) && has(Effect::CameraTransparency));
  EXPECT_FALSE(has(Effect::TranslucentOverlap) || has(Effect::CameraLayers));
  const uint32_t second = quad(grey, 2, 2, 0);
  EXPECT_FALSE(has(Effect::TranslucentOverlap) || has(Effect::CameraLayers));
  m_scene.instances[second].toWorld[3][0] = 0.5;
  EXPECT_TRUE(has(Effect::TranslucentOverlap) && has(Effect::CameraLayers));
  // In line for the light only.
  m_scene.instances[second].toWorld[3][0] = 2;
  m_scene.lights[0].direction = glm::normalize(glm::dvec3(-2, -1, 0));
  EXPECT_TRUE(has(Effect::TranslucentOverlap));
  EXPECT_FALSE(has(Effect::CameraLayers));
}

TEST_F(AnalysisTest, CurvedPanesOverlapThemselves) {
  const uint32_t m = addMaterial(m_scene, paneMaterial("glass", glm::vec3(1), 0.3f));
  addInstance(m_scene, "bulb", addMesh(m_scene, sphereMesh("bulb", m, 8)), at(0, 2, 0));
  EXPECT_TRUE(has(Effect::TranslucentOverlap) && has(Effect::CameraLayers));
}

TEST_F(AnalysisTest, LocalLightsReachAsFarAsTheySay) {
  Light point;
  point.type = LightType::Point;
  point.position = {0, 3, 0};
  point.range = 2;
  m_scene.lights.push_back(point);
  EXPECT_FALSE(effects().lights[1].touchesView);
  EXPECT_FALSE(has(Effect::LocalLights) || has(Effect::MultipleLights));
  m_scene.lights[1].range = 4;
  quad(matteMaterial("between", glm::vec3(1)), 0, 1, 0);
  quad(matteMaterial("above", glm::vec3(1)), 0, 5, 0);
  EXPECT_TRUE(has(Effect::LocalLights) && has(Effect::MultipleLights));
  // Both quads are receivers in view; light and receivers span a box that holds them.
  const Effects e = effects();
  EXPECT_NE(std::ranges::find(e.lights[1].opaqueCasters, 1u), e.lights[1].opaqueCasters.end());
  m_scene.lights[1].type = LightType::Spot;
  m_scene.lights[1].direction = {0, 1, 0};  // away from the floor and the quad between
  m_scene.lights[1].outerCone = 0.2;
  EXPECT_EQ(effects().lights[1].opaqueCasters, (std::vector<uint32_t>{2}));
  m_scene.lights[1].intensity = 0;
  EXPECT_FALSE(effects().lights[1].touchesView);
}

TEST_F(AnalysisTest, MediaInViewOrOnTheWay) {
  Medium medium;
  medium.extinction = glm::vec3(1);
  medium.boxToWorld = at(20, 5, 0);
  m_scene.media = {medium};
  EXPECT_FALSE(has(Effect::ParticipatingMedia));
  m_scene.media[0].boxToWorld = at(0, 30, 0);  // above the camera, before the light
  EXPECT_TRUE(has(Effect::ParticipatingMedia));
  m_scene.media[0].boxToWorld = at(0, 1, 0);
  EXPECT_TRUE(has(Effect::ParticipatingMedia));
}

TEST_F(AnalysisTest, MaterialsInView) {
  EXPECT_FALSE(has(Effect::NormalMaps) || has(Effect::Emission));
  Material m = matteMaterial("lamp", glm::vec3(1));
  m.emissive = {1, 0, 0};
  const uint32_t lamp = quad(m, 20, 1, 0);
  EXPECT_FALSE(has(Effect::Emission));
  m_scene.instances[lamp].toWorld[3][0] = 0;
  EXPECT_TRUE(has(Effect::Emission));
  m.normalTexture.image = 0;
  m_scene.images = {{"n", 1, 1, {128, 128, 255, 255}}};
  quad(m, 0, 1, 0);
  EXPECT_TRUE(has(Effect::NormalMaps));
}

TEST_F(AnalysisTest, UnlitSurfacesReceiveNothing) {
  m_scene.materials[0].unlit = true;
  const Effects e = effects();
  EXPECT_FALSE(e.lights[0].touchesView);
  EXPECT_FALSE(e.present.has(Effect::OpaqueCasters));
}

TEST_F(AnalysisTest, DoesNotDependOnWhereOrHowLargeTheWorldIs) {
  quad(paneMaterial("blue", {0, 0, 1}, 0.5f), 0, 1, 0);
  quad(matteMaterial("b", glm::vec3(1)), 20, 5, 0);
  const Effects near = effects();
  translateScene(m_scene, {1e7, -1e7, 1e7});
  scaleScene(m_scene, 1024);
  const Effects far = effects();
  EXPECT_EQ(near.present, far.present);
  EXPECT_EQ(near.visibleOpaque, far.visibleOpaque);
  EXPECT_EQ(near.lights[0].opaqueCasters, far.lights[0].opaqueCasters);
  EXPECT_EQ(near.lights[0].translucentCasters, far.lights[0].translucentCasters);
}

TEST(Analysis, ProceduralScenesCallForWhatTheyShow) {
  const auto has = [](const char* spec, Effect effect) {
    return analyse(makeScene(spec), 1).present.has(effect);
  };
  EXPECT_TRUE(has("layers", Effect::TranslucentOverlap));
  EXPECT_TRUE(has("layers", Effect::TexturedTransmission));
  EXPECT_FALSE(has("window", Effect::TranslucentOverlap));
  EXPECT_FALSE(has("window", Effect::CameraLayers));
  EXPECT_TRUE(has("window", Effect::ColouredTransmission));
  EXPECT_TRUE(has("teapot", Effect::TranslucentOverlap));
  EXPECT_FALSE(has("spheres_quads:quads=0", Effect::TranslucentCasters));
  EXPECT_TRUE(has("spheres_quads", Effect::CameraLayers));
}

TEST(Analysis, IsFast) {
  const Scene scene = makeScene("spheres_quads:quads=2000,orientation=random");
  const auto start = std::chrono::steady_clock::now();
  const Effects e = analyse(scene, 1);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  EXPECT_GT(e.visibleOpaque.size() + e.visibleTranslucent.size(), 2900u);
  EXPECT_LT(time.count(), 1.0);  // milliseconds where nothing else runs
  RecordProperty("milliseconds", int(1000 * time.count()));
}

TEST(Describe, NamesWhatIsInAScene) {
  const Scene scene = makeScene("layers");
  const Effects e = analyse(scene, 1);
  const nlohmann::json j = describeJson(scene, e);
  EXPECT_EQ(j["name"], "layers");
  EXPECT_EQ(j["triangles"], 8);
  EXPECT_EQ(j["materials"]["translucent"], 3);
  EXPECT_EQ(j["effects"].size(), kEffectCount);
  EXPECT_EQ(j["lights"][0]["translucent_casters"], 3);
  const std::string text = describeText(scene, e);
  for (const char* part : {"layers", "1 opaque, 0 perforated, 3 translucent", "Calls for",
                           "translucent-overlap", "may overlap as the light sees them",
                           "Does not call for", "no light that touches the view has an extent"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_TRUE(j["motion"].is_null());
  EXPECT_EQ(text.find("moves in"), std::string::npos);
}

TEST(Describe, NamesWhatMoves) {
  const Scene scene = makeScene("spheres_quads:quads=5,spheres=5,moving=3?motion:steps=4");
  const Effects e = analyse(scene, 1);
  EXPECT_EQ(describeJson(scene, e)["motion"],
            nlohmann::json({{"steps", 4}, {"camera", false}, {"lights", 0}, {"instances", 3}}));
  EXPECT_NE(describeText(scene, e).find("moves in 4 steps: 3 instances, 0 lights\n"),
            std::string::npos);
}

}  // namespace
}  // namespace sb
