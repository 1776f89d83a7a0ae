// One small broken file for each kind of error: the text names the file, the field, what was found
// and what was expected.
#include <cmath>

#include "suites/scenes/gltf/source/image_codec.h"
#include "suites/scenes/gltf/source/source.h"
#include "tests/scenes/gltf_files.h"

namespace sb::test {
namespace {

using GltfBroken = GltfFiles;

TEST_F(GltfBroken, NoFile) {
  expectError(m_folder / "absent.gltf", {"file not found"});
  expectError(m_folder, {"not a regular file"});
  expectError(file(""), {"is empty"});
}

TEST_F(GltfBroken, Json) {
  expectError(file("{\"asset\":"), {"JSON", "parse error"});
  expectError(file("[1,2]"), {"JSON", "[1,2]", "expected an object"});
  expectError(file(std::string(1000000, '[')), {"JSON", "nested deeper"});
  expectError(file("{\"asset\":{\"version\":\"2.0\"},\"x\":1e999}"), {"JSON", "overflow"});
  std::string deep = "{\"asset\":{\"version\":\"2.0\"},\"extras\":";
  for (int i = 0; i < 200; ++i) deep += "{\"a\":";
  expectError(file(deep + "1" + std::string(201, '}')), {"nested deeper"});
}

TEST_F(GltfBroken, VersionsAndExtensions) {
  json gltf = triangleFile();
  gltf["asset"]["version"] = "1.0";
  expectError(gltf, {"asset.version", "\"1.0\"", "expected 2.x"});
  gltf["asset"].erase("version");
  expectError(gltf, {"asset.version", "is missing"});
  gltf = triangleFile();
  for (const char* name : {"EXT_unheard_of", "KHR_texture_basisu"}) {
    gltf["extensionsRequired"] = {name};
    expectError(gltf, {"extensionsRequired[0]", name, "not supported"});
  }
  expectError(gltf, {"KHR_texture_basisu", "no packaged library reads them",
                     "convert them to PNG, JPEG or WebP (gltf-transform ktxdecompress)"});
  gltf.erase("extensionsRequired");
  for (const char* version :
       {"2", "2.", ".0", "2.0.0", "2.x", "-2.0", "2.-1", "+2.0", " 2.0", "99999999999.0"}) {
    gltf["asset"]["version"] = version;
    expectError(gltf, {"asset.version", version});
  }
}

TEST_F(GltfBroken, TypesAndReferences) {
  json gltf = triangleFile();
  gltf["accessors"][0]["byteOffset"] = "4";
  expectError(gltf, {"accessors[0].byteOffset", "\"4\"", "whole number"});
  gltf["accessors"][0]["byteOffset"] = -4;
  expectError(gltf, {"accessors[0].byteOffset", "-4", ">= 0"});
  gltf = triangleFile();
  gltf["nodes"][0]["mesh"] = 7;
  expectError(gltf, {"nodes[0].mesh", "7", "1 entry in 'meshes'"});
  gltf = triangleFile();
  gltf["meshes"] = {{"primitives", 1}};
  expectError(gltf, {"meshes", "expected an array"});
  gltf = triangleFile();
  gltf["nodes"][0]["translation"] = {1, 2};
  expectError(gltf, {"nodes[0].translation", "[1,2]", "3 numbers"});
  gltf = triangleFile();
  gltf["materials"] = {{{"alphaMode", "GLASS"}}};
  expectError(gltf, {"materials[0].alphaMode", "GLASS", "BLEND"});
}

TEST_F(GltfBroken, CountsAreCheckedBeforeMemoryIsTaken) {
  json gltf = triangleFile();
  gltf["accessors"][0]["count"] = 2000000000;
  expectError(gltf, {"accessors[0]", "needs 24000000000 bytes", "bufferViews[0] has 36"});
  gltf["accessors"][0].erase("bufferView");
  expectError(gltf, {"accessors[0].count", "2000000000", "without a bufferView"});
  gltf = triangleFile();
  gltf["accessors"][0]["count"] = 1e300;
  expectError(gltf, {"accessors[0].count", "whole number"});
  gltf = triangleFile();
  gltf["bufferViews"][0]["byteLength"] = 37;
  expectError(gltf, {"bufferViews[0].byteLength", "37", "buffers[0] has 36"});
  gltf = triangleFile();
  gltf["buffers"][0]["byteLength"] = 40;
  expectError(gltf, {"buffers[0].byteLength", "40", "36 bytes"});
  // The same large accessor many times over.
  gltf = triangleFile();
  gltf["accessors"][0] = {{"componentType", 5126}, {"count", kMaxVertices}, {"type", "VEC3"}};
  gltf["meshes"][0]["primitives"].push_back(gltf["meshes"][0]["primitives"][0]);
  gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
      addFloats(gltf, {0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
  expectError(gltf, {"meshes[0].primitives[1]", "beyond"});
}

TEST_F(GltfBroken, Geometry) {
  json gltf = triangleFile();
  gltf["meshes"][0]["primitives"][0]["indices"] =
      addAccessor(gltf, bytesOf<uint16_t>({0, 1, 3}), 5123, "SCALAR", 3);
  expectError(gltf, {"meshes[0].primitives[0].indices", "element 2 is 3", "3 vertices"});
  gltf = triangleFile();
  gltf["meshes"][0]["primitives"][0]["indices"] = addFloats(gltf, {0, 1, 2}, 1);
  expectError(gltf, {"meshes[0].primitives[0].indices", "5126", "unsigned"});
  gltf = triangleFile();
  gltf["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = addFloats(gltf, {0, 0, 1}, 3);
  expectError(gltf, {"attributes.NORMAL", "1 elements", "POSITION has 3"});
  for (const float bad : {std::nanf(""), INFINITY}) {
    gltf = triangleFile();
    gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
        addFloats(gltf, {0, 0, 0, 1, bad, 0, 0, 1, 0}, 3);
    expectError(gltf, {"attributes.POSITION", "element 1", "expected finite"});
  }
  gltf = triangleFile();
  gltf["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", 0}, {"componentType", 5125}, {"byteOffset", 12}}},  // the float 1
      {"values", {{"bufferView", 0}}}};
  expectError(gltf, {"attributes.POSITION", "sparse index 0", "expected less than 3"});
}

TEST_F(GltfBroken, Nodes) {
  json gltf = triangleFile();
  gltf["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
  gltf["scenes"] = json::array({{{"nodes", json::array()}}});
  expectError(gltf, {"nodes[0]", "loop"});
  gltf = triangleFile();
  gltf["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
  expectError(gltf, {"nodes[1].children[0]", "nodes[0] already"});
  gltf = triangleFile();
  gltf["nodes"][0]["rotation"] = {0, 0, 0, 0};
  expectError(gltf, {"nodes[0].rotation", "no length"});
  gltf["nodes"] = {{{"scale", {1e10, 1e10, 1e10}}, {"children", {1}}},
                   {{"scale", {1e10, 1e10, 1e10}}, {"mesh", 0}}};
  expectError(gltf, {"nodes[1]", "overflows"});
  gltf["nodes"][0]["scale"] = {1e200, 1e200, 1e200};
  expectError(gltf, {"nodes[0]", "overflows"});
}

TEST_F(GltfBroken, Uris) {
  json gltf = triangleFile();
  for (const auto& [uri, why] : std::vector<std::pair<std::string, std::string>>{
           {"absent.bin", "file not found"},
           {"%!Qx", "two hexadecimal digits"},
           {"a%00b", "zero byte"},
           {"http://example.com/a.bin", "not a file"},
           {"/etc/passwd", "absolute path"},
           {"data:application/octet-stream;base64,!!", "invalid base64"},
           {".", "not a regular file"}}) {
    gltf["buffers"][0]["uri"] = uri;
    expectError(gltf, {"buffers[0].uri", why});
  }
}

TEST_F(GltfBroken, Images) {
  json gltf = triangleFile();
  gltf["images"] = {{{"uri", "data:image/png;base64," + base64("\x89PNG\r\n\x1a\n")}}};
  expectError(gltf, {"images[0]", "cut off"});
  // A header that asks for 16384 x 16384 x 2 pixels in a file of 100 bytes.
  std::string bomb("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x40\0\0\0\x40\0\x08\x06\0\0\0\0\0\0\0", 33);
  bomb += std::string("\0\0\0\0IDAT\0\0\0\0\0\0\0\0IEND\0\0\0\0", 24);
  gltf["images"] = {{{"uri", "data:image/png;base64," + base64(bomb)}}};
  expectError(gltf, {"images[0]"});
  std::string error;
  EXPECT_TRUE(
      decodeImage({reinterpret_cast<const uint8_t*>(bomb.data()), bomb.size()}, 1000000, error)
          .rgba.empty());
  EXPECT_NE(error.find("16384x16384"), error.npos) << error;
}

TEST_F(GltfBroken, Extras) {
  json gltf = triangleFile();
  gltf["materials"] = {{{"extras", {{"shadowbench", {{"alfa", 0.5}}}}}}};
  expectError(gltf, {"materials[0].extras.shadowbench", "alfa", "alpha"});
  gltf["materials"] = {{{"extras", {{"shadowbench", {{"t", {1, 2, 0}}}}}}}};
  expectError(gltf, {"materials[0].extras.shadowbench.t[1]", "2", "from 0"});
  gltf = triangleFile();
  const auto expectLight = [&](const char* type, json extent, std::vector<std::string> words) {
    gltf["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", type}, {"extras", {{"shadowbench", std::move(extent)}}}}};
    gltf["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    words.insert(words.begin(), "lights[0].extras.shadowbench");
    expectError(gltf, words);
  };
  expectLight("point", {{"shape", "cube"}}, {".shape", "cube", "disc"});
  expectLight("point", {{"shape", 7}}, {".shape"});
  expectLight("point", {{"shape", "disc"}}, {".half_axes", "missing", "disc"});
  expectLight("point", {{"shape", "sphere"}}, {".radius", "missing"});
  expectLight("point", {{"half_axes", {1, 2}}}, {".half_axes", "no property of a sphere"});
  expectLight("point", {{"shape", "disc"}, {"radius", 1}, {"half_axes", {1, 2}}},
              {".radius", "no property of a disc"});
  expectLight("point", {{"shape", "ellipsoid"}, {"half_axes", {1, 2}}},
              {".half_axes", "3 numbers"});
  expectLight("point", {{"shape", "rectangle"}, {"half_axes", {1, 0}}}, {".half_axes[1]", "0"});
  expectLight("point", {{"shape", "rectangle"}, {"half_axes", {-1, 1}}}, {".half_axes[0]", "-1"});
  expectLight("point", {{"radius", -1}}, {".radius", "-1"});
  expectLight("directional", {{"radius", 2}}, {".radius", "2", "1.5"});
  expectLight("directional", {{"shape", "disc"}}, {"shape", "radius"});
  gltf = triangleFile();
  gltf["nodes"][0]["extras"] = {{"shadowbench", {{"medium", {{"kind", "fog"}}}}}};
  expectError(gltf, {"nodes[0].extras.shadowbench.medium.kind", "fog", "smoke"});
}

TEST_F(GltfBroken, EveryCutOfAGlbIsSurvived) {
  const std::string text = triangleFile().dump();
  std::string glb = "glTF" + bytesOf<uint32_t>({2, 0, 0}) + "JSON" + text;
  while (glb.size() % 4 != 0) glb += ' ';
  const uint32_t length = uint32_t(glb.size()), chunk = length - 20;
  std::memcpy(glb.data() + 8, &length, 4);
  std::memcpy(glb.data() + 12, &chunk, 4);
  EXPECT_EQ(loadGltf(file(glb, "test.glb")).instances.size(), 1u);
  for (size_t cut = 0; cut < glb.size(); cut += 7)
    EXPECT_THROW(loadGltf(file(glb.substr(0, cut), "test.glb")), InputError) << cut;
}

TEST_F(GltfBroken, ChangedBytesLoadOrGiveInputErrors) {
  const std::string text = triangleFile().dump();
  for (size_t at = 0; at < text.size(); at += 3)
    for (const char with : {'9', '"', '-'}) {
      std::string changed = text;
      changed[at] = with;
      try {
        loadGltf(file(changed));
      } catch (const InputError&) {
      }
    }
}

}  // namespace
}  // namespace sb::test
