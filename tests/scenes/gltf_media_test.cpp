// Media in files: what is read of each kind, what is refused and why, and that they are written as
// they were read.
#include <cmath>

#include "suites/scenes/gltf/write/export.h"
#include "tests/scenes/gltf_files.h"

namespace sb::test {
namespace {

using GltfMedia = GltfFiles;

/// A file with a node that holds a medium.
json mediumFile(const json& medium) {
  json gltf = triangleFile();
  gltf["nodes"].push_back({{"name", "cloud"}, {"scale", {2, 3, 4}}});
  gltf["nodes"][1]["extras"]["shadowbench"]["medium"] = medium;
  gltf["scenes"][0]["nodes"].push_back(1);
  return gltf;
}

json gridFile(const std::vector<float>& density, const json& size) {
  json gltf = mediumFile({{"kind", "grid"}, {"extinction", {1, 1, 1}}, {"size", size}});
  gltf["nodes"][1]["extras"]["shadowbench"]["medium"]["density"] = addFloats(gltf, density, 1);
  return gltf;
}

json& mediumOf(json& gltf) { return gltf["nodes"][1]["extras"]["shadowbench"]["medium"]; }

TEST_F(GltfMedia, AGridIsReadFromAnAccessor) {
  const Scene scene = load(gridFile({0, 1, 2, 3, 4, 5.5f}, {1, 2, 3}));
  ASSERT_EQ(scene.media.size(), 1u);
  const Medium& m = scene.media[0];
  EXPECT_EQ(m.kind, MediumKind::Grid);
  EXPECT_EQ(m.name, "cloud");
  EXPECT_EQ(m.size, glm::uvec3(1, 2, 3));
  EXPECT_EQ(m.density, (std::vector<float>{0, 1, 2, 3, 4, 5.5f}));
  EXPECT_EQ(m.boxToWorld[2][2], 4);
  // Packed as bytes, too.
  json gltf = mediumFile({{"kind", "grid"}, {"extinction", {1, 1, 1}}, {"size", {2, 1, 1}}});
  mediumOf(gltf)["density"] = addAccessor(gltf, std::string("\x33\xff", 2), 5121, "SCALAR", 2);
  gltf["accessors"].back()["normalized"] = true;
  EXPECT_EQ(load(gltf).media.at(0).density, (std::vector<float>{0.2f, 1}));
}

TEST_F(GltfMedia, AGridThatDoesNotFitItsSizeIsRefused) {
  const std::string field = "nodes[1].extras.shadowbench.medium";
  expectError(gridFile({1, 2, 3}, {1, 2, 2}),
              {field + ".density", "3 elements", "expected 4 of 1"});
  expectError(gridFile({1, -2}, {1, 2, 1}), {field + ".density", "element 1 is -2", "at least 0"});
  expectError(gridFile({1, NAN}, {1, 2, 1}), {field + ".density", "finite"});
  expectError(gridFile({1}, {1, 1}), {field + ".size", "3 whole numbers"});
  expectError(gridFile({1}, {1, 0, 1}), {field + ".size[1]", "is 0", "from 1"});
  expectError(gridFile({1}, {1, 1, 1.5}), {field + ".size[2]", "1.5", "whole"});
  json gltf = gridFile({1}, {1, 1, 1});
  mediumOf(gltf)["density"] = 7;
  expectError(gltf, {field + ".density", "7"});
  mediumOf(gltf)["density"] = 0;  // the triangle's places
  expectError(gltf, {field + ".density", "elements of 3"});
  mediumOf(gltf).erase("density");
  expectError(gltf, {field + ".density", "is missing"});
  mediumOf(gltf)["kind"] = "smoke";
  expectError(gltf, {field, "size"});
}

TEST_F(GltfMedia, SmokeRises) {
  json gltf = mediumFile({{"kind", "smoke"}, {"extinction", {1, 1, 1}}, {"time", 2.5}});
  EXPECT_EQ(load(gltf).media.at(0).time, 2.5);
  mediumOf(gltf)["time"] = -1;
  expectError(gltf, {"medium.time", "-1"});
}

TEST_F(GltfMedia, SixteenAreReadAndNoMore) {
  json gltf = triangleFile();
  for (size_t i = 0; i < 16; ++i) {
    gltf["nodes"].push_back({{"name", "cloud"}});
    gltf["nodes"][i + 1]["extras"]["shadowbench"]["medium"]["extinction"] = {1, 1, 1};
    gltf["scenes"][0]["nodes"].push_back(i + 1);
  }
  EXPECT_EQ(load(gltf).media.size(), 16u);
  gltf["nodes"].push_back(gltf["nodes"][16]);
  gltf["scenes"][0]["nodes"].push_back(17);
  expectError(gltf, {"nodes[17]", "one medium more than the 16"});
}

TEST_F(GltfMedia, FlattenedOnesAreLeftOut) {
  json gltf = mediumFile({{"extinction", {1, 1, 1}}});
  gltf["nodes"][1]["scale"] = {1, 0, 1};
  const Scene scene = load(gltf);
  EXPECT_TRUE(scene.media.empty());
  EXPECT_TRUE(warns(scene, "its medium is left out"));
}

TEST_F(GltfMedia, AllKindsAreWrittenAsTheyWereRead) {
  Scene scene = load(gridFile({0, 0.25f, 1e-7f, 3}, {2, 1, 2}));
  scene.media.push_back({.name = "smoke",
                         .kind = MediumKind::Smoke,
                         .extinction = {1, 2, 3},
                         .albedo = {0.1f, 0.2f, 0.3f},
                         .anisotropy = -0.3f,
                         .seed = 77,
                         .time = 0.1});
  scene.media.push_back({.name = "fog", .extinction = {1, 2, 3}});
  exportGlb(scene, m_folder / "scene.glb");
  const Scene back = loadGltf(m_folder / "scene.glb");
  ASSERT_EQ(back.media.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    const Medium &a = scene.media[i], &b = back.media[i];
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.boxToWorld, b.boxToWorld);
    EXPECT_EQ(a.extinction, b.extinction);
    EXPECT_EQ(a.albedo, b.albedo);
    EXPECT_EQ(a.anisotropy, b.anisotropy);
    EXPECT_EQ(a.seed, b.seed);
    EXPECT_EQ(a.time, b.time);
    EXPECT_EQ(a.size, b.size);
    EXPECT_EQ(a.density, b.density);
  }
}

}  // namespace
}  // namespace sb::test
