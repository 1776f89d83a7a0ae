// Skins, morph targets, animations and instances as they stand at t = 0, and packed files.
#include "techniques/scene/box.h"
#include "tests/scenes/gltf_files.h"
#include "tests/scenes/gltf_packed.h"

namespace sb::test {
namespace {

using GltfPosed = GltfFiles;

/// World positions of an instance's vertices.
std::vector<glm::dvec3> worldOf(const Scene& scene, size_t instance) {
  const Instance& i = scene.instances.at(instance);
  std::vector<glm::dvec3> points;
  for (const glm::vec3& p : scene.meshes.at(i.mesh).positions)
    points.emplace_back(i.toWorld * glm::dvec4(glm::dvec3(p), 1));
  return points;
}

void expectPoints(const Scene& scene, size_t instance, const std::vector<glm::dvec3>& right) {
  const auto points = worldOf(scene, instance);
  ASSERT_EQ(points.size(), right.size());
  for (size_t i = 0; i < right.size(); ++i)
    EXPECT_LT(glm::length(points[i] - right[i]), 1e-6)
        << i << ": " << points[i].x << " " << points[i].y << " " << points[i].z;
}

TEST_F(GltfPosed, ASkinReplacesTheNodesTransform) {
  const Scene scene = load(skinnedFile());
  expectPoints(scene, 0, {{1, 2, 3}, {1, 3, 3}, {0, 2, 3}});
  EXPECT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.meshes.size(), 1u);
}

TEST_F(GltfPosed, InverseBindMatricesAndWeightsCount) {
  json gltf = skinnedFile();
  // A second joint at the origin of the world, half of every weight: midway between both.
  gltf["nodes"].push_back(json::object());
  gltf["scenes"][0]["nodes"].push_back(2);
  gltf["skins"][0] = {{"joints", {1, 2}}};
  gltf["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] =
      addAccessor(gltf, bytesOf<uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}), 5121, "VEC4", 3);
  gltf["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
      addFloats(gltf, {1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0}, 4);
  expectPoints(load(gltf), 0, {{0.5, 1, 1.5}, {1, 1.5, 1.5}, {0, 1.5, 1.5}});
  gltf = skinnedFile();
  gltf["skins"][0]["inverseBindMatrices"] = addAccessor(
      gltf, bytesOf<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 10, 1}), 5126, "MAT4", 1);
  expectPoints(load(gltf), 0, {{1, 2, 13}, {1, 3, 13}, {0, 2, 13}});
}

TEST_F(GltfPosed, BrokenSkinsAreNamed) {
  json gltf = skinnedFile();
  gltf["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] =
      addAccessor(gltf, bytesOf<uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 7, 0, 0, 0}), 5121, "VEC4", 3);
  expectError(gltf, {"attributes.JOINTS_0", "element 2 names joint 7", "the skin has 1"});
  gltf = skinnedFile();
  gltf["skins"][0]["joints"] = {9};
  expectError(gltf, {"skins[0].joints[0]", "9", "'nodes'"});
  gltf = skinnedFile();
  gltf["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
      addFloats(gltf, {1, 0, 0, 0, NAN, 0, 0, 0, 1, 0, 0, 0}, 4);
  expectError(gltf, {"attributes.WEIGHTS_0", "element 1", "expected finite"});
}

TEST_F(GltfPosed, MorphWeightsOfMeshNodeAndAnimation) {
  json gltf = morphedFile();
  expectPoints(load(gltf), 0, {{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}});
  // Those of a node go before; another node keeps the mesh's.
  gltf["nodes"][0]["weights"] = {0, 2};
  gltf["nodes"].push_back({{"mesh", 0}});
  gltf["scenes"][0]["nodes"] = {0, 1};
  const Scene both = load(gltf);
  expectPoints(both, 0, {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}});
  expectPoints(both, 1, {{0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}});
  // And those of the animation before both: its first key, of a spline the value between tangents.
  const size_t times = addFloats(gltf, {0, 1}, 1);
  gltf["animations"] = json::parse(R"([{
    "channels": [{"sampler": 0, "target": {"node": 0, "path": "weights"}}],
    "samplers": [{"interpolation": "CUBICSPLINE"}]}])");
  json& sampler = gltf["animations"][0]["samplers"][0];
  sampler["input"] = times;
  sampler["output"] = addFloats(gltf, {9, 9, 3, 0, 9, 9, 9, 9, 1, 1, 9, 9}, 1);
  expectPoints(load(gltf), 0, {{0, 0, 3}, {1, 0, 3}, {0, 1, 3}});
  gltf = morphedFile();
  gltf["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] =
      addFloats(gltf, {0, 0, INFINITY, 0, 0, 1, 0, 0, 1}, 3);
  expectError(gltf, {"meshes[0].primitives[0].targets[0].POSITION", "element 0", "finite"});
}

TEST_F(GltfPosed, TheFirstKeyOfTheFirstAnimationCounts) {
  json gltf = animatedFile();
  gltf["animations"].push_back(gltf["animations"][0]);
  gltf["animations"][1]["name"] = "run";
  const Scene scene = load(gltf);
  expectPoints(scene, 0, {{5, 6, 7}, {6, 6, 7}, {5, 7, 7}});
  EXPECT_TRUE(warns(scene, "holds 2 animations; animations[0] 'walk' is shown at t = 0"));
  gltf = animatedFile();
  gltf["animations"][0]["samplers"][0]["output"] = addFloats(gltf, {5, NAN, 7, 8, 9, 10}, 3);
  expectError(gltf, {"animations[0].samplers[0].output", "element 0", "finite"});
  gltf["animations"][0]["channels"][0]["sampler"] = 3;
  expectError(gltf, {"animations[0].channels[0].sampler", "3", "1 samplers"});
}

TEST_F(GltfPosed, InstancesOfTheGpuExtension) {
  const Scene scene = load(instancedFile());
  ASSERT_EQ(scene.instances.size(), 3u);
  EXPECT_EQ(scene.meshes.size(), 1u);
  expectPoints(scene, 1, {{2, 0, 0}, {4, 0, 0}, {2, 2, 0}});
  expectPoints(scene, 2, {{4, 0, 0}, {7, 0, 0}, {4, 3, 0}});
  json gltf = instancedFile();
  gltf["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] =
      addFloats(gltf, {1, 1, 1}, 3);
  expectError(gltf, {"EXT_mesh_gpu_instancing.attributes.", "elements", "another attribute has"});
}

TEST_F(GltfPosed, HiddenNodesAndNodesWithParents) {
  json gltf = triangleFile();
  gltf["nodes"] = json::parse(R"([{"children": [1], "translation": [0, 0, 7]}, {"mesh": 0}])");
  gltf["scenes"][0]["nodes"] = {0, 1, 1};
  const Scene scene = load(gltf);
  ASSERT_EQ(scene.instances.size(), 1u);  // once, under its parent
  expectPoints(scene, 0, {{0, 0, 7}, {1, 0, 7}, {0, 1, 7}});
  EXPECT_TRUE(warns(scene, "scenes[0].nodes[1] is 1, which is a child of nodes[0]"));
  EXPECT_TRUE(warns(scene, "names a node twice"));
  gltf["scenes"][0]["nodes"] = {1};
  expectPoints(load(gltf), 0, {{0, 0, 7}, {1, 0, 7}, {0, 1, 7}});
  gltf["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = false;
  gltf["scenes"][0]["nodes"] = {0};
  EXPECT_TRUE(load(gltf).instances.empty());
}

TEST_F(GltfPosed, PackedFilesLoadAsUnpackedOnes) {
  expectPoints(load(meshoptFile()), 0, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Scene square = load(dracoFile());
  EXPECT_EQ(square.meshes.at(0).triangleCount(), 2u);
  const Box box = sceneBox(square);
  EXPECT_EQ(box.low, glm::dvec3(0));
  EXPECT_EQ(box.high, glm::dvec3(1, 1, 0));
  const Scene red = load(webpFile());
  ASSERT_EQ(red.images.size(), 1u);
  EXPECT_EQ(red.images[0].rgba.at(0), 255);
  EXPECT_EQ(red.images[0].rgba.at(1), 0);
  EXPECT_TRUE(red.materials.at(0).baseColorTexture.present());
}

TEST_F(GltfPosed, BrokenPackedFilesAreNamed) {
  json gltf = meshoptFile();
  json* packed = &gltf["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
  (*packed)["mode"] = "CUBES";
  expectError(gltf,
              {"bufferViews[0].extensions.EXT_meshopt_compression.mode", "CUBES", "TRIANGLES"});
  (*packed)["mode"] = "ATTRIBUTES";
  (*packed)["byteStride"] = 6;
  expectError(gltf, {"EXT_meshopt_compression.byteStride", "6", "multiple of 4"});
  (*packed)["byteStride"] = 12;
  (*packed)["count"] = 1u << 30;
  expectError(gltf, {"bufferViews[0].extensions.EXT_meshopt_compression", "MiB"});
  (*packed)["count"] = 2;
  expectError(gltf, {"EXT_meshopt_compression.count", "24 bytes", "36"});
  gltf = meshoptFile();
  packed = &gltf["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
  (*packed)["byteLength"] = 3;
  expectError(gltf, {"EXT_meshopt_compression", "cannot be unpacked"});
  gltf = dracoFile();
  json& extension = gltf["meshes"][0]["primitives"][0]["extensions"]["KHR_draco_mesh_compression"];
  extension["attributes"]["POSITION"] = 77;
  expectError(gltf, {"KHR_draco_mesh_compression.attributes.POSITION", "77"});
  gltf = dracoFile();
  gltf["accessors"][0]["count"] = 5;
  expectError(gltf, {"KHR_draco_mesh_compression.attributes.POSITION", "4 elements", "5"});
  gltf = webpFile();
  gltf["images"][0]["uri"] =
      "data:image/webp;base64," + base64(std::string("RIFF\x10\0\0\0WEBPVP8L\0\0\0\0", 20));
  expectError(gltf, {"images[0]", "cannot be decoded"});
}

}  // namespace
}  // namespace sb::test
