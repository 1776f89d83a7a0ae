// Every file of the folder of scenes made by others: what must load loads, what is broken gives an
// InputError that names file, field and reason. Nothing crashes, hangs or eats memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <set>

#include "suites/scenes/gltf/loader.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

namespace fs = std::filesystem;
const fs::path kShared = SHADOWBENCH_SHARED_SCENES;

std::vector<fs::path> filesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
      files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// What a loaded scene promises to techniques (scene.h).
void expectSound(const Scene& scene) {
  EXPECT_FALSE(scene.cameras.empty());
  EXPECT_FALSE(scene.lights.empty());
  for (const Mesh& mesh : scene.meshes) {
    ASSERT_LT(mesh.material, scene.materials.size());
    const Material& material = scene.materials[mesh.material];
    const size_t n = mesh.positions.size();
    ASSERT_EQ(mesh.normals.size(), n);
    EXPECT_EQ(mesh.tangents.size(), material.normalTexture.present() ? n : 0);
    for (const size_t size : {mesh.uv0.size(), mesh.uv1.size(), mesh.colors.size()})
      EXPECT_TRUE(size == 0 || size == n);
    ASSERT_EQ(mesh.triangleKeys.size() * 3, mesh.indices.size());
    for (const uint32_t i : mesh.indices) {
      ASSERT_LT(i, n);
      ASSERT_NEAR(glm::length(mesh.normals[i]), 1, 1e-4);
    }
    for (const glm::vec4& t : mesh.tangents) ASSERT_NEAR(glm::length(glm::vec3(t)), 1, 1e-4);
  }
  for (const Instance& instance : scene.instances) ASSERT_LT(instance.mesh, scene.meshes.size());
  for (const Image& image : scene.images)
    EXPECT_EQ(image.rgba.size(), size_t(image.width) * image.height * 4);
}

size_t validatorErrors(const fs::path& file) {
  std::ifstream in(file.string() + ".report.json");
  return in ? nlohmann::json::parse(in)["issues"]["numErrors"].get<size_t>() : 0;
}

/// Files of the validator's set whose only fault cannot change the picture: they load, and the
/// policy that says so is in suites/scenes/gltf/EXTRAS.md.
const std::set<std::string> kHarmless = {"accessor/byteoffset_no_bufferview.gltf",
                                         "accessor/empty_array.gltf",
                                         "accessor/float_normalized.gltf",
                                         "buffer/empty_array.gltf",
                                         "buffer/invalid_uri_data_mime.gltf",
                                         "buffer/no_bin_chunk.glb",
                                         "glb/bom.glb",
                                         "image/empty_array.gltf",
                                         "image/invalid_data_uri_mime_type.gltf",
                                         "image/not_found.gltf",
                                         "json/bom.gltf",
                                         "material/empty_array.gltf",
                                         "mesh/accessor_attribute_uint32.gltf",
                                         "mesh/empty_array.gltf",
                                         "mesh/invalid_attribute.gltf",
                                         "mesh/invalid_attribute_escaped_name.gltf",
                                         "mesh/invalid_indexed_attribute.gltf",
                                         "mesh/morph_attribute_invalid_count.gltf",
                                         "mesh/morph_attribute_no_base.gltf",
                                         "mesh/morph_position_accessor_no_bounds.gltf",
                                         "mesh/morph_unequal_targets_count.gltf",
                                         "mesh/morph_weights_wrong_count.gltf",
                                         "mesh/position_accessor_no_bounds.gltf",
                                         "mesh/unequal_joints.gltf",
                                         "mesh/unresolved_morph_positions.gltf",
                                         "mesh/uv.gltf",
                                         "node/empty_array.gltf",
                                         "node/empty_children_array.gltf",
                                         "node/matrix_trs.gltf",
                                         "node/node_skin_without_skinned_mesh.gltf",
                                         "node/node_weights_invalid.gltf",
                                         "node/rotation_non_unit.gltf",
                                         "node/skin_with_no_mesh.gltf",
                                         "node/unresolved_skin.gltf",
                                         "node/weights_with_no_mesh.gltf"};

/// Files without an error that ask for what is not supported, or whose buffers have no data.
const std::set<std::string> kUnsupported = {
    "accessor/unknown_type.gltf", "accessor/valid.gltf", "asset/min_version_valid.gltf",
    "buffer/non_relative_uri.gltf", "json/integer_written_as_float.gltf"};

TEST(SharedScenes, WhatMustLoadLoads) {
  if (!fs::exists(kShared)) GTEST_SKIP() << kShared << " is not there; its scenes were left out";
  for (const fs::path& file : filesBelow(kShared)) {
    const std::string name = fs::relative(file, kShared).string();
    if (name.starts_with("hard/gltf_validator") || name.starts_with("hard/tinygltf")) continue;
    SCOPED_TRACE(name);
    Scene scene;
    ASSERT_NO_THROW(scene = loadGltf(file));
    // The one form that is left out, with a warning that names it: points and lines.
    const auto leftOut = [](const std::string& w) { return w.find("is drawn as") != w.npos; };
    EXPECT_EQ(scene.instances.empty(), std::ranges::any_of(scene.warnings, leftOut));
    EXPECT_EQ(scene.name, file.stem().string());
    expectSound(scene);
    if (std::getenv("SHADOWBENCH_VERBOSE")) {
      std::cout << name << ": " << scene.instances.size() << " instances\n";
      for (const std::string& w : scene.warnings) std::cout << "    " << w << "\n";
    }
  }
}

TEST(SharedScenes, BrokenFilesGiveErrorsThatNameTheFile) {
  if (!fs::exists(kShared)) GTEST_SKIP() << kShared << " is not there; its files were left out";
  size_t refused = 0, harmless = 0, sound = 0;
  for (const fs::path& file : filesBelow(kShared / "hard")) {
    const std::string name = fs::relative(file, kShared / "hard").string();
    const bool validator = name.starts_with("gltf_validator"), tiny = name.starts_with("tinygltf");
    if (!validator && !tiny) continue;
    SCOPED_TRACE(name);
    const bool broken = tiny || validatorErrors(file) > 0;
    const std::string shortName = validator ? name.substr(std::strlen("gltf_validator/")) : name;
    std::string error;
    try {
      const Scene scene = loadGltf(file);
      expectSound(scene);
      broken ? ++harmless : ++sound;
      EXPECT_EQ(broken, kHarmless.contains(shortName)) << "loaded";
      if (std::getenv("SHADOWBENCH_VERBOSE")) {
        std::cout << name << (broken ? ": BROKEN, loads\n" : ": loads\n");
        for (const std::string& w : scene.warnings) std::cout << "    " << w << "\n";
      }
    } catch (const InputError& e) {
      error = e.what();
      ++refused;
      EXPECT_FALSE(kHarmless.contains(shortName)) << error;
      EXPECT_EQ(!broken, kUnsupported.contains(shortName)) << error;
      EXPECT_NE(error.find(file.string()), std::string::npos) << error;
      if (std::getenv("SHADOWBENCH_VERBOSE"))
        std::cout << name << (broken ? ": refused: " : ": SOUND, REFUSED: ")
                  << error.substr(file.string().size()) << "\n";
    }
  }
  std::cout << refused << " refused, " << harmless << " harmless faults load, " << sound
            << " without faults load\n";
}

}  // namespace
}  // namespace sb
