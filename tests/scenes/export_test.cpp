// What is exported reads back as the same scene.
#include <cmath>
#include <map>

#include "suites/scenes/gltf/write/export.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/scenes/gltf_files.h"

namespace sb::test {
namespace {

using GltfExport = GltfFiles;

void expectNear(const glm::dmat4& a, const glm::dmat4& b) {
  for (int i = 0; i < 16; ++i) EXPECT_NEAR(a[i / 4][i % 4], b[i / 4][i % 4], 1e-12);
}

void expectEqual(const TextureSlot& a, const TextureSlot& b) {
  EXPECT_EQ(a.image, b.image);
  EXPECT_TRUE(a.wrapU == b.wrapU && a.wrapV == b.wrapV && a.nearest == b.nearest);
  EXPECT_TRUE(a.srgb == b.srgb && a.uvSet == b.uvSet);
  for (int row = 0; row < 2; ++row)
    EXPECT_LT(glm::length(a.uvTransform[row] - b.uvTransform[row]), 1e-6);
}

void expectEqual(const Material& a, const Material& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_TRUE(a.alphaMode == b.alphaMode && a.doubleSided == b.doubleSided && a.unlit == b.unlit);
  if (a.alphaMode == AlphaMode::Mask) {
    EXPECT_EQ(a.alphaCutoff, b.alphaCutoff);
  }
  EXPECT_EQ(a.baseColor, b.baseColor);
  EXPECT_EQ(a.metallic, b.metallic);
  EXPECT_EQ(a.roughness, b.roughness);
  EXPECT_EQ(a.emissive, b.emissive);
  EXPECT_EQ(a.transmission, b.transmission);
  EXPECT_NEAR(a.thickness, b.thickness, 1e-6 * a.thickness);
  EXPECT_EQ(a.attenuationColor, b.attenuationColor);
  EXPECT_EQ(a.attenuationDistance, b.attenuationDistance);
  EXPECT_EQ(a.opticsOverride, b.opticsOverride);
  EXPECT_EQ(a.overrideAlpha, b.overrideAlpha);
  EXPECT_EQ(a.overrideTransmission, b.overrideTransmission);
  expectEqual(a.baseColorTexture, b.baseColorTexture);
  expectEqual(a.metallicRoughnessTexture, b.metallicRoughnessTexture);
  expectEqual(a.normalTexture, b.normalTexture);
  expectEqual(a.occlusionTexture, b.occlusionTexture);
  expectEqual(a.emissiveTexture, b.emissiveTexture);
  if (a.normalTexture.present()) {
    EXPECT_EQ(a.normalScale, b.normalScale);
  }
}

void expectEqual(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.images.size(), b.images.size());
  for (size_t i = 0; i < a.images.size(); ++i) EXPECT_EQ(a.images[i].rgba, b.images[i].rgba);
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (size_t i = 0; i < a.materials.size(); ++i) expectEqual(a.materials[i], b.materials[i]);
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (size_t i = 0; i < a.meshes.size(); ++i) {
    const Mesh &p = a.meshes[i], &q = b.meshes[i];
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.material, q.material);
    EXPECT_EQ(p.positions, q.positions);
    EXPECT_EQ(p.normals, q.normals);
    EXPECT_EQ(p.tangents, q.tangents);
    EXPECT_TRUE(p.uv0 == q.uv0 && p.uv1 == q.uv1 && p.colors == q.colors);
    EXPECT_EQ(p.indices, q.indices);
    EXPECT_EQ(p.boundsMax, q.boundsMax);
  }
  ASSERT_EQ(a.instances.size(), b.instances.size());
  for (size_t i = 0; i < a.instances.size(); ++i) {
    EXPECT_EQ(a.instances[i].name, b.instances[i].name);
    EXPECT_EQ(a.instances[i].mesh, b.instances[i].mesh);
    EXPECT_EQ(a.instances[i].toWorld, b.instances[i].toWorld);
  }
  ASSERT_EQ(a.lights.size(), b.lights.size());
  for (size_t i = 0; i < a.lights.size(); ++i) {
    const Light &p = a.lights[i], &q = b.lights[i];
    EXPECT_TRUE(p.name == q.name && p.type == q.type && p.color == q.color);
    EXPECT_EQ(p.intensity, q.intensity);
    EXPECT_EQ(p.angularRadius, q.angularRadius);
    EXPECT_EQ(p.shape, q.shape);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(glm::length(p.halfAxes[c] - q.halfAxes[c]), 0, 1e-12);
    EXPECT_NEAR(glm::length(p.direction - q.direction), 0, 1e-12);
    if (p.type == LightType::Directional) continue;
    EXPECT_EQ(p.position, q.position);
    EXPECT_EQ(p.range, q.range);
    if (p.type == LightType::Spot) {
      EXPECT_EQ(p.outerCone, q.outerCone);
    }
  }
  ASSERT_EQ(a.cameras.size(), b.cameras.size());
  for (size_t i = 0; i < a.cameras.size(); ++i) {
    expectNear(a.cameras[i].toWorld, b.cameras[i].toWorld);
    EXPECT_EQ(a.cameras[i].orthographic, b.cameras[i].orthographic);
    if (!a.cameras[i].orthographic) {
      EXPECT_EQ(a.cameras[i].fovY, b.cameras[i].fovY);
    }
    EXPECT_EQ(a.cameras[i].nearPlane, b.cameras[i].nearPlane);
    EXPECT_EQ(a.cameras[i].farPlane, b.cameras[i].farPlane);
  }
  ASSERT_EQ(a.media.size(), b.media.size());
  for (size_t i = 0; i < a.media.size(); ++i) {
    EXPECT_EQ(a.media[i].extinction, b.media[i].extinction);
    EXPECT_EQ(a.media[i].boxToWorld, b.media[i].boxToWorld);
    EXPECT_TRUE(a.media[i].kind == b.media[i].kind && a.media[i].seed == b.media[i].seed);
  }
  EXPECT_EQ(a.ambient, b.ambient);
  EXPECT_EQ(a.background, b.background);
}

TEST_F(GltfExport, ProceduralScenesReadBack) {
  for (const std::string spec : {"layers", "window", "teapot:segments=4",
                                 "spheres_quads:spheres=20,quads=20,orientation=random"}) {
    SCOPED_TRACE(spec);
    const Scene scene = makeScene(spec);
    exportGlb(scene, m_folder / "scene.glb");
    const Scene back = loadGltf(m_folder / "scene.glb");
    EXPECT_TRUE(back.warnings.empty()) << back.warnings.front();
    expectEqual(scene, back);
  }
}

TEST_F(GltfExport, EverythingAMaterialAndALightCanHold) {
  Scene scene = makeScene("layers");
  Material& m = scene.materials[0];
  m.transmission = 0.5f;
  m.thickness = 3;
  m.attenuationDistance = 2;
  m.attenuationColor = {0.5f, 0.25f, 1};
  m.emissive = {0.3f, 5.7f, 0};
  m.baseColorTexture = {.image = 0, .nearest = true, .srgb = true};
  m.baseColorTexture.uvTransform = {glm::vec3(0.3f, 0.8f, 0.1f), glm::vec3(-0.6f, 0.4f, 0.2f)};
  scene.materials[1].opticsOverride = true;
  scene.materials[1].overrideTransmission = {0.1f, 0.2f, 0.3f};
  scene.materials[2].alphaMode = AlphaMode::Mask;
  scene.materials[2].alphaCutoff = 0.3f;
  scene.materials[3].unlit = true;
  scene.lights.push_back({.name = "spot",
                          .type = LightType::Spot,
                          .position = {1, 2, 3},
                          .direction = {0, 0, 1},
                          .range = 10,
                          .innerCone = 0.1,
                          .outerCone = 0.4,
                          .shape = LightShape::Ellipsoid,
                          .halfAxes = glm::dmat3(0.2)});
  scene.lights[0].angularRadius = 0.01;
  const glm::dmat3 turned(glm::dvec3(0.6, 0.8, 0), glm::dvec3(-0.8, 0.6, 0), glm::dvec3(0, 0, 1));
  const auto scaled = [&](const glm::dvec3& s) {
    return glm::dmat3(s.x * turned[0], s.y * turned[1], s.z * turned[2]);
  };
  for (const auto& [shape, axes] : {std::pair(LightShape::Ellipsoid, glm::dvec3(3, 2, 1)),
                                    std::pair(LightShape::Rectangle, glm::dvec3(2, 0.5, 0)),
                                    std::pair(LightShape::Disc, glm::dvec3(1, 4, 0))})
    scene.lights.push_back({.name = "lamp",
                            .type = LightType::Point,
                            .position = {-1, 5, 2},
                            .shape = shape,
                            .halfAxes = scaled(axes)});
  scene.media.push_back(
      {.name = "smoke", .kind = MediumKind::Smoke, .extinction = {1, 2, 3}, .seed = 77});
  scene.cameras.push_back(scene.cameras[0]);
  scene.cameras[1].orthographic = true;
  scene.background = {0.1f, 0.2f, 0.3f};
  // Mirrored and scaled: the winding turns when read, thickness grows with the node.
  scene.instances[0].toWorld = glm::dmat4(-2);
  scene.instances[0].toWorld[3] = {0, 0, 0, 1};
  exportGlb(scene, m_folder / "scene.glb");
  expectEqual(scene, loadGltf(m_folder / "scene.glb"));
}

TEST_F(GltfExport, SharedScenesReadBackAsWhatTheyWereReadAs) {
  const std::filesystem::path shared = SHADOWBENCH_SHARED_SCENES;
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << shared << " is not there; left out";
  for (const char* name :
       {"AlphaBlendModeTest/AlphaBlendModeTest.glb", "AttenuationTest/AttenuationTest.glb",
        "hard/asset_generator/Node_NegativeScale/Node_NegativeScale_11.gltf"}) {
    SCOPED_TRACE(name);
    const Scene scene = loadGltf(shared / name);
    exportGlb(scene, m_folder / "scene.glb");
    expectEqual(scene, loadGltf(m_folder / "scene.glb"));
  }
}

TEST_F(GltfExport, AFileThatCannotBeWrittenLeavesNothing) {
  EXPECT_THROW(exportGlb(makeScene("layers"), m_folder / "no" / "such.glb"), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(m_folder));
}

}  // namespace
}  // namespace sb::test
