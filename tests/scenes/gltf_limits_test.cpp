// Files that ask for more than their size may, that name files elsewhere, that hold text unfit for
// a terminal, or numbers that become infinite.
#include <cfloat>

#include "base/text.h"
#include "suites/scenes/gltf/source/image_codec.h"
#include "suites/scenes/gltf/write/export.h"
#include "tests/scenes/gltf_files.h"
#include "tests/scenes/png_bytes.h"

namespace sb::test {
namespace {

class GltfLimits : public GltfFiles {
 protected:
  /// Refused for its memory, before any is taken.
  void expectTooLarge(const json& gltf, const std::string& field) {
    expectError(gltf, {field, "MiB"});
  }
};

TEST_F(GltfLimits, ZerosThatNoViewHolds) {
  json gltf = triangleFile();
  gltf["accessors"][0] = {{"componentType", 5126}, {"count", 1 << 25}, {"type", "VEC3"}};
  expectTooLarge(gltf, "meshes[0].primitives[0]");
  // The same through sparse accessors, indices, morph targets, joints and instances.
  gltf["accessors"][0]["sparse"] = json::parse(R"({
    "count": 1,
    "indices": {"bufferView": 0, "componentType": 5125},
    "values": {"bufferView": 0, "byteOffset": 12}})");
  expectTooLarge(gltf, "meshes[0].primitives[0]");
  gltf = triangleFile();
  gltf["accessors"].push_back({{"componentType", 5125}, {"count", 1 << 25}, {"type", "SCALAR"}});
  gltf["meshes"][0]["primitives"][0]["indices"] = 1;
  expectTooLarge(gltf, "meshes[0].primitives[0]");
  gltf = triangleFile();
  gltf["accessors"].push_back({{"componentType", 5126}, {"count", 1 << 20}, {"type", "VEC3"}});
  gltf["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = 1;
  expectTooLarge(gltf, "nodes[0].extensions.EXT_mesh_gpu_instancing");
}

TEST_F(GltfLimits, ManyEmptyThings) {
  for (const char* key : {"materials", "nodes", "textures", "samplers"}) {
    json gltf = triangleFile();
    json& list = gltf[key];
    for (int i = list.is_array() ? int(list.size()) : 0; i < 1000000; ++i)
      list.push_back(json::object());
    expectTooLarge(gltf, key);
  }
}

TEST_F(GltfLimits, PicturesAreAsLargeAsTheirHeadersSay) {
  std::string error;
  const auto decode = [&](const std::string& png) {
    error.clear();
    return decodeImage({reinterpret_cast<const uint8_t*>(png.data()), png.size()}, size_t(1) << 28,
                       error);
  };
  EXPECT_FALSE(decode(pngBytes(3, 2)).rgba.empty()) << error;
  // A hundred megabytes of zeros behind the pixels of a picture of 3 x 2.
  EXPECT_TRUE(decode(pngBytes(3, 2, 100 << 20)).rgba.empty());
  EXPECT_NE(error.find("unpack to more"), error.npos) << error;
  EXPECT_TRUE(decode(pngBytes(20000, 1)).rgba.empty());
  EXPECT_NE(error.find("20000x1"), error.npos) << error;
  EXPECT_NE(error.find("16384"), error.npos) << error;
  json gltf = triangleFile();
  // 16384 x 16384 pixels of one colour.
  gltf["images"][0]["uri"] = "data:image/png;base64," + base64(pngHeader(16384, 16384) + pngEnd());
  expectTooLarge(gltf, "images[0]");
}

TEST_F(GltfLimits, FilesOutsideTheFolder) {
  namespace fs = std::filesystem;
  fs::create_directories(m_folder / "in" / "deep");
  std::ofstream(m_folder / "secret.bin") << std::string(36, '\0');
  fs::create_symlink(m_folder / "secret.bin", m_folder / "in" / "link.bin");
  fs::create_directory_symlink(m_folder, m_folder / "in" / "up");
  json gltf = triangleFile();
  for (const std::string& uri : std::vector<std::string>
       {"../secret.bin", "%2e%2e/secret.bin", ".%2E%2Fsecret.bin", "deep/../../secret.bin",
        "link.bin", "up/secret.bin", (m_folder / "secret.bin").string()}) {
    gltf["buffers"][0]["uri"] = uri;
    const fs::path path = file(gltf.dump(), "in/test.gltf");
    expectError(path, {"buffers[0].uri", "--allow-outside"});
    EXPECT_NO_THROW(loadGltf(path, {.scene = "", .allowOutside = true})) << uri;
    json images = triangleFile();
    images["images"][0]["uri"] = uri;
    expectError(file(images.dump(), "in/test.gltf"), {"images[0].uri", "--allow-outside"});
  }
  // Within the folder all forms are fine, the glTF file itself behind a link too.
  std::ofstream(m_folder / "in" / "a b?.bin") << std::string(36, '\0');
  for (const std::string uri : {"a b?.bin", "a%20b%3F.bin", "deep/../a b?.bin", "./a b?.bin"}) {
    gltf["buffers"][0]["uri"] = uri;
    EXPECT_NO_THROW(loadGltf(file(gltf.dump(), "in/test.gltf"))) << uri;
  }
  fs::create_symlink(m_folder / "in" / "test.gltf", m_folder / "linked.gltf");
  EXPECT_THROW(loadGltf(m_folder / "absent.gltf"), InputError);
}

TEST_F(GltfLimits, TextFitForTerminals) {
  json gltf = triangleFile();
  const std::string evil = "\x1b]0;owned\x07";
  gltf["nodes"][0]["name"] = gltf["meshes"][0]["name"] = evil;
  gltf["materials"] = {{{"name", evil}}};
  gltf["extensionsUsed"] = {evil};
  gltf["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
  json& lights = gltf["extensions"]["KHR_lights_punctual"]["lights"];
  lights = json::parse(R"([{"type": "point"}])");
  lights[0]["name"] = evil;
  const Scene scene = load(gltf);
  const auto clean = [](const std::string& text) { return text == base::printable(text); };
  EXPECT_TRUE(clean(scene.instances.at(0).name) && clean(scene.meshes.at(0).name));
  EXPECT_TRUE(clean(scene.materials.at(0).name) && clean(scene.lights.at(0).name));
  for (const std::string& w : scene.warnings) EXPECT_TRUE(clean(w)) << w;
}

TEST_F(GltfLimits, ErrorsAreShortAndKeepBothEnds) {
  json gltf = triangleFile();
  gltf["meshes"][0]["primitives"][0]["attributes"][std::string(5000, 'x') + "\n"] = 17;
  try {
    load(gltf);
    ADD_FAILURE() << "loaded";
  } catch (const InputError& e) {
    const std::string text = e.what();
    EXPECT_LE(text.size(), 290u);
    EXPECT_EQ(text, base::printable(text));
    EXPECT_NE(text.find("meshes[0].primitives[0].attributes"), text.npos) << text;
    EXPECT_NE(text.find("1 entry in 'accessors'"), text.npos) << text;
  }
  // A thousand warnings are no flood, and finding them is no square of their number.
  gltf = triangleFile();
  for (int i = 0; i < 1000; ++i) gltf["extensionsUsed"].push_back("X_" + std::to_string(i));
  const Scene scene = load(gltf);
  EXPECT_LE(scene.warnings.size(), 102u);
  EXPECT_TRUE(warns(scene, "more warnings"));
}

TEST_F(GltfLimits, NumbersThatAFloatCannotHold) {
  const auto refuse = [&](const char* pointer, const json& value, const std::string& field) {
    json gltf = triangleFile();
    gltf["materials"] = json::array({json::object()});
    gltf["extensions"]["KHR_lights_punctual"]["lights"] = json::parse(R"([{"type": "point"}])");
    gltf["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    gltf[json::json_pointer(pointer)] = value;
    expectError(gltf, {field, "float"});
  };
  const json huge = {1e300, 0, 0}, huge4 = {1e300, 0, 0, 1};
  refuse("/materials/0/pbrMetallicRoughness/baseColorFactor", huge4, "baseColorFactor");
  refuse("/materials/0/emissiveFactor", huge, "emissiveFactor");
  refuse("/materials/0/alphaCutoff", 1e300, "alphaCutoff");
  refuse("/materials/0/extensions/KHR_materials_volume/thicknessFactor", 1e39, "thicknessFactor");
  refuse("/materials/0/extensions/KHR_materials_volume/attenuationDistance", 1e39,
         "attenuationDis");
  refuse("/extensions/KHR_lights_punctual/lights/0/intensity", 1e39, "intensity");
  refuse("/extensions/KHR_lights_punctual/lights/0/color", huge, "color");
  refuse("/scenes/0/extras/shadowbench/background", huge, "background[0]");
  refuse("/scenes/0/extras/shadowbench/sky", huge, "sky[0]");
  // Products of two that are finite each.
  json gltf = triangleFile();
  gltf["materials"] = {{{"emissiveFactor", {1e30, 0, 0}}}};
  gltf["materials"][0]["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 1e30;
  expectError(gltf, {"materials[0].emissiveFactor", "float"});
  gltf = triangleFile();
  gltf["nodes"][0]["translation"] = {1e30, 0, 0};
  expectError(gltf, {"nodes[0]", "overflows", "1e18"});
  gltf["nodes"][0]["translation"] = {0, 0, 0};
  gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
      addFloats(gltf, {0, 0, 0, 1e30f, 0, 0, 0, 1e30f, 0}, 3);
  expectError(gltf, {"nodes[0]", "beyond 1e18"});
}

TEST_F(GltfLimits, WholeNumbersBeyond31BitsDoNotWrap) {
  json gltf = triangleFile();
  gltf["materials"] = json::parse(R"([{"extensions": {"KHR_materials_volume": {
    "thicknessFactor": 4294967295, "attenuationDistance": 3000000000}}}])");
  gltf["meshes"][0]["primitives"][0]["material"] = 0;
  gltf["nodes"][0]["extras"]["shadowbench"]["medium"] =
      json::parse(R"({"extinction": [1, 1, 1], "seed": 4294967295})");
  const Scene scene = load(gltf);
  EXPECT_EQ(scene.materials.at(0).thickness, 4294967296.0f);
  EXPECT_EQ(scene.materials.at(0).attenuationDistance, 3e9f);
  EXPECT_EQ(scene.media.at(0).seed, 4294967295u);
}

TEST_F(GltfLimits, NanInAnyAttributeNamesAccessorAndField) {
  const std::vector<std::pair<const char*, int>> attributes = {
      {"NORMAL", 3}, {"TEXCOORD_0", 2}, {"TEXCOORD_1", 2}, {"COLOR_0", 4}, {"COLOR_0", 3}};
  for (const auto& [name, components] : attributes)
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
      json gltf = triangleFile();
      std::vector<float> values(size_t(3 * components), 1.0f);
      values[size_t(components)] = bad;
      gltf["meshes"][0]["primitives"][0]["attributes"][name] = addFloats(gltf, values, components);
      expectError(gltf, {std::string("meshes[0].primitives[0].attributes.") + name,
                         "accessors[1] element 1", "expected finite numbers"});
    }
}

TEST_F(GltfLimits, MessagesNameTheField) {
  json gltf = triangleFile();
  gltf["cameras"] = json::parse(R"([{"type": "fisheye"}])");
  expectError(gltf, {"cameras[0].type", "\"fisheye\"", "perspective or orthographic"});
  gltf["cameras"] = json::parse(R"([{"type": "perspective"}])");
  expectError(gltf, {"cameras[0].perspective", "is missing"});
  gltf["cameras"] = json::parse(R"([{"type": "orthographic", "orthographic": 3}])");
  expectError(gltf, {"cameras[0].orthographic", "3", "an object"});
  gltf = triangleFile();
  gltf["extensions"]["KHR_lights_punctual"]["lights"] = json::parse(R"([{"type": "spot"}])");
  expectError(gltf, {"extensions.KHR_lights_punctual.lights[0].spot", "is missing"});
  gltf["extensions"]["KHR_lights_punctual"]["lights"] = json::parse(R"([{"type": "sun"}])");
  expectError(gltf, {"extensions.KHR_lights_punctual.lights[0].type", "\"sun\"", "spot"});
  gltf = triangleFile();
  gltf["accessors"][0]["count"] = 0;
  expectError(gltf, {"accessors[0].count", "is 0, expected at least 1"});
  try {
    load(gltf);
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()).find("1.0"), std::string::npos) << e.what();
  }
  gltf = triangleFile();
  gltf["asset"]["version"] = "1.0";
  expectError(gltf, {"asset.version", "glTF 1.0"});
  expectError(file(R"({"meshes":{"m":{"primitives":[]}},"nodes":{}})"), {"meshes", "glTF 1.0"});
}

TEST_F(GltfLimits, HarmlessFaultsAreWarnings) {
  json gltf = triangleFile();
  gltf["extensionsRequired"] =
      gltf["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_materials_ior"};
  EXPECT_TRUE(warns(load(gltf), "KHR_materials_clearcoat is required but not supported"));
  gltf = triangleFile();
  gltf["buffers"].push_back({{"byteLength", 8}});
  EXPECT_TRUE(warns(load(gltf), "buffers[1] has no data and is not used"));
  // Nodes hidden by a scale of 0: lights, cameras and meshes under them.
  gltf = triangleFile();
  gltf["extensionsUsed"] = {"KHR_lights_punctual"};
  gltf["extensions"]["KHR_lights_punctual"]["lights"] =
      json::parse(R"([{"type": "point"}, {"type": "directional"}])");
  gltf["cameras"] =
      json::parse(R"([{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}])");
  for (int i = 0; i < 2; ++i) {
    json node = json::parse(R"({"scale": [0, 0, 0], "translation": [1, 2, 3]})");
    node["extensions"]["KHR_lights_punctual"]["light"] = i;
    gltf["nodes"].push_back(node);
  }
  gltf["nodes"].push_back(json::parse(R"({"scale": [0, 0, 0], "camera": 0, "mesh": 0})"));
  gltf["scenes"][0]["nodes"] = {0, 1, 2, 3};
  const Scene scene = load(gltf);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_TRUE(scene.lights[0].type == LightType::Point);
  EXPECT_EQ(scene.lights[0].position, glm::dvec3(1, 2, 3));
  EXPECT_TRUE(warns(scene, "nodes[2] has scale 0: its light 'light1' has no direction"));
  EXPECT_TRUE(warns(scene, "nodes[3] has scale 0: its camera 'camera0' is left out"));
  EXPECT_TRUE(warns(scene, "nodes[3] is flattened"));
}

TEST_F(GltfLimits, WhatLoadsIsExportedSoThatItLoads) {
  json gltf = triangleFile();
  gltf["images"][0]["uri"] = "data:image/png;base64," + base64(pngBytes(3, 2));
  gltf["textures"] = json::parse(R"([{"source": 0}])");
  gltf["materials"] = json::parse(R"([{
    "emissiveFactor": [3e38, 0, 0],
    "pbrMetallicRoughness": {"baseColorTexture": {
      "index": 0,
      "extensions": {"KHR_texture_transform": {"scale": [0, 2], "rotation": 0.7}}}}}])");
  gltf["meshes"][0]["primitives"][0]["material"] = 0;
  gltf["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
      addFloats(gltf, {0, 0, 1, 0, 0, 1}, 2);
  for (const json& one :
       {gltf, json::parse(R"({"asset": {"version": "2.0"}})")}) {  // and an empty one
    const Scene scene = load(one);
    exportGlb(scene, m_folder / "out.glb");
    const Scene back = loadGltf(m_folder / "out.glb");
    EXPECT_EQ(back.instances.size(), scene.instances.size());
    EXPECT_EQ(back.sky, scene.sky);
    EXPECT_EQ(back.background, scene.background);
    EXPECT_EQ(back.lights.size(), scene.lights.size());
    for (size_t i = 0; i < scene.materials.size(); ++i) {
      EXPECT_EQ(back.materials.at(i).emissive, scene.materials[i].emissive);
      for (int row = 0; row < 2; ++row)
        EXPECT_LT(glm::length(back.materials[i].baseColorTexture.uvTransform[size_t(row)] -
                              scene.materials[i].baseColorTexture.uvTransform[size_t(row)]),
                  1e-6);
    }
  }
}

}  // namespace
}  // namespace sb::test
