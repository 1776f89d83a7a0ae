// Valid files in unusual forms become what glTF says they are.
#include <cmath>

#include "suites/scenes/gltf/source/image_codec.h"
#include "techniques/scene/light_area.h"
#include "techniques/scene/optics.h"
#include "tests/scenes/gltf_files.h"

namespace sb::test {
namespace {

using GltfForms = GltfFiles;

glm::vec3 faceNormal(const Mesh& mesh, size_t t, const glm::dmat4& toWorld = glm::dmat4(1)) {
  const auto at = [&](size_t c) {
    return glm::dvec3(toWorld * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[3 * t + c]]), 1));
  };
  return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
}

TEST_F(GltfForms, BareTriangle) {
  const Scene scene = load(triangleFile());
  EXPECT_EQ(scene.name, "test");
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].normals[1], glm::vec3(0, 0, 1));
  EXPECT_EQ(scene.meshes[0].boundsMax, glm::vec3(1, 1, 0));
  EXPECT_EQ(scene.materials.at(scene.meshes[0].material).name, "default");
  EXPECT_TRUE(warns(scene, "no camera"));
  EXPECT_TRUE(warns(scene, "no light"));
}

TEST_F(GltfForms, StripsAndFansKeepTheirWinding) {
  for (const int mode : {5, 6}) {
    json gltf = triangleFile();
    const std::vector<float> strip = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const std::vector<float> fan = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    json& primitive = gltf["meshes"][0]["primitives"][0];
    primitive["mode"] = mode;
    primitive["attributes"]["POSITION"] = addFloats(gltf, mode == 5 ? strip : fan, 3);
    const Scene scene = load(gltf);
    ASSERT_EQ(scene.meshes.at(0).triangleCount(), 2u);
    for (size_t t = 0; t < 2; ++t) EXPECT_GT(faceNormal(scene.meshes[0], t).z, 0.99f) << mode;
  }
}

TEST_F(GltfForms, IndicesOfEveryWidth) {
  for (const int type : {5121, 5123, 5125}) {
    json gltf = triangleFile();
    const std::string bytes = type == 5121   ? bytesOf<uint8_t>({2, 1, 0})
                              : type == 5123 ? bytesOf<uint16_t>({2, 1, 0})
                                             : bytesOf<uint32_t>({2, 1, 0});
    gltf["meshes"][0]["primitives"][0]["indices"] = addAccessor(gltf, bytes, type, "SCALAR", 3);
    EXPECT_LT(faceNormal(load(gltf).meshes.at(0), 0).z, -0.99f) << type;
  }
}

TEST_F(GltfForms, SparseAndNormalizedAccessors) {
  json gltf = triangleFile();
  const size_t index = addAccessor(gltf, bytesOf<uint16_t>({1}), 5123, "SCALAR", 1);
  const size_t value = addFloats(gltf, {5, 0, 0}, 3);
  gltf["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices",
       {{"bufferView", gltf["accessors"][index]["bufferView"]}, {"componentType", 5123}}},
      {"values", {{"bufferView", gltf["accessors"][value]["bufferView"]}}}};
  const size_t colours = addAccessor(
      gltf, bytesOf<uint8_t>({255, 0, 51, 0, 255, 255, 0, 255, 0, 0, 255, 255}), 5121, "VEC4", 3);
  gltf["accessors"][colours]["normalized"] = true;
  gltf["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = colours;
  const Mesh mesh = load(gltf).meshes.at(0);
  EXPECT_EQ(mesh.positions[1], glm::vec3(5, 0, 0));
  EXPECT_EQ(mesh.colors[0], glm::vec4(1, 0, 0.2f, 0));
}

TEST_F(GltfForms, NegativeScaleKeepsFrontFacesOutward) {
  json gltf = triangleFile();
  gltf["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"scale", {-1, 1, 1}}}};
  gltf["scenes"][0]["nodes"] = {0, 1};
  const Scene scene = load(gltf);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.meshes.size(), 2u);
  for (const Instance& instance : scene.instances)
    EXPECT_GT(faceNormal(scene.meshes[instance.mesh], 0, instance.toWorld).z, 0.99f);
  EXPECT_NE(scene.instances[0].key, scene.instances[1].key);
}

TEST_F(GltfForms, MeshesAreSharedByInstances) {
  json gltf = triangleFile();
  gltf["nodes"] = {{{"children", {1, 2}}, {"translation", {10, 0, 0}}},
                   {{"mesh", 0}},
                   {{"mesh", 0}, {"translation", {0, 1e7, 0}}}};
  const Scene scene = load(gltf);
  EXPECT_EQ(scene.meshes.size(), 1u);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(glm::dvec3(scene.instances[1].toWorld[3]), glm::dvec3(10, 1e7, 0));
}

TEST_F(GltfForms, DegenerateTrianglesAreDroppedAndKeysStay) {
  json gltf = triangleFile();
  gltf["meshes"][0]["primitives"][0]["indices"] = addAccessor(
      gltf, bytesOf<uint16_t>({0, 0, 1, 0, 1, 2, 2, 2, 2, 0, 2, 1}), 5123, "SCALAR", 12);
  const Scene scene = load(gltf);
  EXPECT_EQ(scene.meshes.at(0).triangleKeys, (std::vector<uint32_t>{1, 3}));
  EXPECT_TRUE(warns(scene, "2 triangles without area"));
}

TEST_F(GltfForms, LightsHaveShapes) {
  json gltf = triangleFile();
  gltf["extensionsUsed"] = {"KHR_lights_punctual"};
  const auto shaped = [](const char* type, json extent) {
    return json{{"type", type}, {"extras", {{"shadowbench", std::move(extent)}}}};
  };
  gltf["extensions"]["KHR_lights_punctual"]["lights"] = {
      shaped("point", {{"shape", "ellipsoid"}, {"half_axes", {3, 2, 1}}}),
      shaped("spot", {{"shape", "rectangle"}, {"half_axes", {2, 0.5}}}),
      shaped("point", {{"shape", "disc"}, {"half_axes", {1, 4}}}),
      shaped("point", {{"shape", "sphere"}, {"radius", 0.5}}),
      shaped("directional", {{"radius", 0.1}}),
      {{"type", "point"}}};
  gltf["extensions"]["KHR_lights_punctual"]["lights"][1]["spot"] = json::object();
  gltf["nodes"] = {{{"mesh", 0}}};
  gltf["scenes"][0]["nodes"] = {0};
  for (int i = 0; i < 6; ++i) {
    // x to -z, scaled: an extent has no scale.
    gltf["nodes"].push_back({{"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}},
                             {"scale", {5, 5, 5}},
                             {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
    gltf["scenes"][0]["nodes"].push_back(i + 1);
  }
  const Scene scene = load(gltf);
  ASSERT_EQ(scene.lights.size(), 6u);
  const auto expectAxes = [&](size_t light, const glm::dvec3& a, const glm::dvec3& b,
                              const glm::dvec3& c) {
    const glm::dmat3 expected(a, b, c), &found = scene.lights[light].halfAxes;
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(glm::length(found[i] - expected[i]), 0, 1e-12) << light << " " << i;
  };
  EXPECT_EQ(scene.lights[0].shape, LightShape::Ellipsoid);
  expectAxes(0, {0, 0, -3}, {0, 2, 0}, {1, 0, 0});
  EXPECT_EQ(scene.lights[1].shape, LightShape::Rectangle);
  expectAxes(1, {0, 0, -2}, {0, 0.5, 0}, {0, 0, 0});
  EXPECT_EQ(scene.lights[2].shape, LightShape::Disc);
  expectAxes(2, {0, 0, -1}, {0, 4, 0}, {0, 0, 0});
  EXPECT_TRUE(isSphere(scene.lights[3]));
  EXPECT_EQ(scene.lights[3].halfAxes, glm::dmat3(0.5));
  EXPECT_EQ(scene.lights[4].angularRadius, 0.1);
  EXPECT_FALSE(isAreaLight(scene.lights[5]));
  // A node without axes has none to give.
  gltf["nodes"][3]["scale"] = {0, 0, 0};
  const Scene hidden = load(gltf);
  EXPECT_EQ(hidden.lights.size(), 5u);
  EXPECT_TRUE(warns(hidden, "has no axes and is left out"));
}

TEST_F(GltfForms, LightsCamerasMediaAndExtras) {
  json gltf = triangleFile();
  gltf["extensionsUsed"] = {"KHR_lights_punctual"};
  gltf["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"},
       {"intensity", 50},
       {"range", 9},
       {"color", {1, 0.5, 0}},
       {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}},
       {"extras", {{"shadowbench", {{"radius", 0.25}}}}}}};
  gltf["cameras"] = {{{"type", "orthographic"},
                      {"orthographic", {{"xmag", 2}, {"ymag", 3}, {"znear", 1}, {"zfar", 9}}}},
                     {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.5}}}}};
  gltf["nodes"] = {
      {{"mesh", 0}},
      {{"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}},
       {"translation", {0, 4, 0}},
       {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
      {{"camera", 0}, {"scale", {3, 3, 3}}},
      {{"camera", 1}, {"translation", {0, 0, 8}}},
      {{"scale", {2, 3, 4}},
       {"extras",
        {{"shadowbench",
          {{"medium", {{"kind", "smoke"}, {"extinction", {1, 2, 3}}, {"seed", 9}}}}}}}}};
  gltf["scenes"][0] = {{"nodes", {0, 1, 2, 3, 4}},
                       {"extras", {{"shadowbench", {{"background", {0.5, 0, 0}}}}}}};
  const Scene scene = load(gltf);
  ASSERT_EQ(scene.lights.size(), 1u);
  const Light& light = scene.lights[0];
  EXPECT_EQ(light.type, LightType::Spot);
  EXPECT_NEAR(glm::length(light.direction - glm::dvec3(0, -1, 0)), 0, 1e-12);
  EXPECT_EQ(light.position, glm::dvec3(0, 4, 0));
  EXPECT_TRUE(isSphere(light));
  EXPECT_EQ(light.halfAxes, glm::dmat3(0.25));
  EXPECT_EQ(light.key, 0u);
  EXPECT_EQ(light.range, 9);
  EXPECT_NEAR(light.outerCone, 0.3, 1e-12);
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_TRUE(scene.cameras[0].orthographic);
  EXPECT_EQ(scene.cameras[0].halfHeight, 3);
  EXPECT_EQ(scene.cameras[0].toWorld, glm::dmat4(1));  // without its scale
  EXPECT_GT(scene.cameras[1].farPlane, 8);             // endless in the file
  ASSERT_EQ(scene.media.size(), 1u);
  EXPECT_EQ(scene.media[0].kind, MediumKind::Smoke);
  EXPECT_EQ(scene.media[0].extinction, glm::vec3(1, 2, 3));
  EXPECT_EQ(scene.media[0].boxToWorld[1][1], 3);
  EXPECT_EQ(scene.background, glm::vec3(0.5f, 0, 0));
}

TEST_F(GltfForms, MaterialsAndTextures) {
  Image checker{"checker", 2, 2, std::vector<uint8_t>(16, 255)};
  checker.rgba[0] = 7;
  const std::vector<uint8_t> png = encodePng(checker);
  json gltf = triangleFile();
  const std::string name(png.begin(), png.end());
  file(name, "my checker.png");
  gltf["images"] = {{{"uri", "my%20checker.png"}}};
  gltf["samplers"] = {{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}};
  gltf["textures"] = {{{"source", 0}, {"sampler", 0}}};
  json info = {{"index", 0}, {"texCoord", 1}};
  info["extensions"]["KHR_texture_transform"] = {
      {"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}, {"texCoord", 0}};
  gltf["materials"] = {{{"pbrMetallicRoughness",
                         {{"baseColorTexture", info}, {"baseColorFactor", {1, 0.5, 0.25, 1}}}},
                        {"normalTexture", {{"index", 0}, {"scale", 0.5}}},
                        {"alphaMode", "MASK"},
                        {"alphaCutoff", 0.25},
                        {"emissiveFactor", {1, 0, 0}},
                        {"extensions",
                         {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
                          {"KHR_materials_unlit", json::object()},
                          {"KHR_materials_transmission", {{"transmissionFactor", 0.75}}},
                          {"KHR_materials_volume",
                           {{"thicknessFactor", 2},
                            {"attenuationDistance", 8},
                            {"attenuationColor", {1, 0, 0}}}}}}}};
  json& primitive = gltf["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  primitive["attributes"]["TEXCOORD_0"] = addFloats(gltf, {0, 0, 1, 0, 0, 1}, 2);
  gltf["nodes"][0]["scale"] = {2, 2, 2};
  const Scene scene = load(gltf);
  ASSERT_EQ(scene.materials.size(), 1u);
  const Material& m = scene.materials[0];
  EXPECT_EQ(scene.images.at(0).rgba[0], 7);
  EXPECT_EQ(m.baseColorTexture.wrapU, Wrap::ClampToEdge);
  EXPECT_EQ(m.baseColorTexture.wrapV, Wrap::MirroredRepeat);
  EXPECT_TRUE(m.baseColorTexture.nearest && m.baseColorTexture.srgb);
  EXPECT_FALSE(m.normalTexture.srgb);
  EXPECT_EQ(m.baseColorTexture.uvSet, 0u);
  // The extension's own example: the lower left quadrant.
  const auto& rows = m.baseColorTexture.uvTransform;
  EXPECT_NEAR(glm::dot(rows[0], glm::vec3(1, 1, 1)), 0.5, 1e-6);
  EXPECT_NEAR(glm::dot(rows[1], glm::vec3(1, 1, 1)), 0.5, 1e-6);
  EXPECT_EQ(m.emissive, glm::vec3(4, 0, 0));
  EXPECT_TRUE(m.unlit);
  EXPECT_EQ(m.transmission, 0.75f);
  EXPECT_NEAR(m.thickness, 4, 1e-5);  // mesh units, in a node of scale 2
  const Mesh& mesh = scene.meshes.at(0);
  ASSERT_EQ(mesh.tangents.size(), 3u);
  // u runs along x, v along y: the bitangent cross(n, t) w points to where v falls.
  EXPECT_NEAR(mesh.tangents[0].x, 1, 1e-6);
  EXPECT_EQ(mesh.tangents[0].w, -1);
}

TEST_F(GltfForms, AbsentImageCostsTheTextureOnly) {
  json gltf = triangleFile();
  gltf["images"] = {{{"uri", "absent.png"}}};
  gltf["textures"] = {{{"source", 0}}};
  gltf["materials"] = {{{"emissiveTexture", {{"index", 0}}}}};
  const Scene scene = load(gltf);
  EXPECT_FALSE(scene.materials.at(0).emissiveTexture.present());
  EXPECT_TRUE(warns(scene, "images[0].uri"));
}

TEST_F(GltfForms, DeepTreesNeedNoStack) {
  json gltf = triangleFile();
  gltf["nodes"] = json::array();
  constexpr int kDepth = 20000;
  for (int i = 0; i < kDepth; ++i)
    gltf["nodes"].push_back({{"children", {i + 1}}, {"translation", {1, 0, 0}}});
  gltf["nodes"].push_back({{"mesh", 0}});
  EXPECT_EQ(load(gltf).instances.at(0).toWorld[3][0], kDepth);
}

}  // namespace
}  // namespace sb::test
