// Small glTF files for tests: a triangle's JSON to be changed, and a folder that goes away.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "suites/scenes/gltf/loader.h"
#include "techniques/plan/error.h"
#include "tests/scenes/gltf_json.h"

namespace sb::test {

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
