// Small glTF files for tests: a triangle's JSON to be changed, and a folder that goes away.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "suites/scenes/gltf_loader.h"
#include "techniques/common/error.h"

namespace sb::test {

using nlohmann::json;

inline std::string base64(const std::string& bytes) {
  const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t word = 0;
    for (size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? uint8_t(bytes[i + k]) : 0);
    for (size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

template <typename T>
std::string bytesOf(const std::vector<T>& values) {
  return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// Adds a buffer, a view of it and an accessor; returns the accessor's index.
inline size_t addAccessor(json& gltf, const std::string& bytes, int componentType,
                          const std::string& type, size_t count) {
  gltf["buffers"].push_back({{"byteLength", bytes.size()},
                             {"uri", "data:application/octet-stream;base64," + base64(bytes)}});
  gltf["bufferViews"].push_back(
      {{"buffer", gltf["buffers"].size() - 1}, {"byteLength", bytes.size()}});
  gltf["accessors"].push_back({{"bufferView", gltf["bufferViews"].size() - 1},
                               {"componentType", componentType},
                               {"count", count},
                               {"type", type}});
  return gltf["accessors"].size() - 1;
}
inline size_t addFloats(json& gltf, const std::vector<float>& values, int components) {
  const std::string type = components == 1 ? "SCALAR" : "VEC" + std::to_string(components);
  return addAccessor(gltf, bytesOf(values), 5126, type, values.size() / size_t(components));
}

/// A sound file that shows the triangle (0,0,0), (1,0,0), (0,1,0).
inline json triangleFile() {
  json gltf = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
  const size_t positions = addFloats(gltf, {0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
  gltf["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", positions}}}}}}}};
  gltf["nodes"] = {{{"mesh", 0}}};
  gltf["scenes"] = {{{"nodes", {0}}}};
  return gltf;
}

class GltfFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    m_folder =
        std::filesystem::temp_directory_path() / ("shadowbench-test-" + std::to_string(getpid()));
    std::filesystem::create_directories(m_folder);
  }
  void TearDown() override { std::filesystem::remove_all(m_folder); }

  std::filesystem::path file(const std::string& text, const std::string& name = "test.gltf") {
    std::ofstream(m_folder / name, std::ios::binary) << text;
    return m_folder / name;
  }
  Scene load(const json& gltf) { return loadGltf(file(gltf.dump())); }

  /// Expects an InputError that names the file and holds every one of `parts`.
  void expectError(const std::filesystem::path& path, const std::vector<std::string>& parts) {
    try {
      loadGltf(path);
      ADD_FAILURE() << "loaded; expected an error with '" << parts.front() << "'";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(path.string()), std::string::npos) << e.what();
      for (const std::string& part : parts)
        EXPECT_NE(std::string(e.what()).find(part), std::string::npos)
            << e.what() << "\n  lacks: " << part;
    }
  }
  void expectError(const json& gltf, const std::vector<std::string>& parts) {
    expectError(file(gltf.dump()), parts);
  }
  static bool warns(const Scene& scene, const std::string& part) {
    for (const std::string& warning : scene.warnings)
      if (warning.find(part) != std::string::npos) return true;
    return false;
  }

  std::filesystem::path m_folder;
};

}  // namespace sb::test
