// Transforms of whole scenes: what they change, and that keys and data stay with what they name.
#include "suites/scenes/edit/transform.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "suites/scenes/edit/mesh_tools.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/scene/box.h"
#include "techniques/scene/light_area.h"

namespace sb {
namespace {

TEST(Transform, TranslationMovesEverything) {
  Scene scene = makeScene("layers");
  const Scene before = scene;
  translateScene(scene, {1024, -2048, 4096});
  for (size_t i = 0; i < scene.instances.size(); ++i)
    EXPECT_NEAR(glm::length(scene.instances[i].toWorld[3] - before.instances[i].toWorld[3] -
                            glm::dvec4(1024, -2048, 4096, 0)),
                0, 1e-9);
  EXPECT_EQ(scene.camera().eye(), before.camera().eye() + glm::dvec3(1024, -2048, 4096));
}

TEST(Transform, ScalingKeepsThePicture) {
  Scene scene = makeScene("teapot");
  Light spot;
  spot.type = LightType::Spot;
  spot.position = {1, 2, 3};
  spot.range = 5;
  makeSphere(spot, 0.5);
  spot.intensity = 7;
  scene.lights.push_back(spot);
  scene.media.push_back({.extinction = glm::vec3(8)});
  scene.materials[0].thickness = 1;
  scaleScene(scene, 4);
  const Light& s = scene.lights[1];
  EXPECT_EQ(s.position, glm::dvec3(4, 8, 12));
  EXPECT_EQ(s.range, 20);
  EXPECT_EQ(s.halfAxes, glm::dmat3(2));
  EXPECT_EQ(s.intensity, 112);  // candela over distance squared stays
  EXPECT_EQ(scene.lights[0].intensity, makeScene("teapot").lights[0].intensity);
  EXPECT_EQ(scene.media[0].extinction, glm::vec3(2));
  EXPECT_EQ(scene.materials[0].thickness, 4);
  EXPECT_EQ(scene.camera().nearPlane, 8);
  EXPECT_EQ(glm::length(glm::dvec3(scene.camera().toWorld[0])),
            glm::length(glm::dvec3(makeScene("teapot").camera().toWorld[0])));
}

TEST(Transform, PermutationKeepsKeysWithTheirTriangles) {
  Scene scene = makeScene("teapot:segments=3");
  const Scene before = scene;
  permuteScene(scene, 5);
  EXPECT_EQ(sceneBox(scene).low, sceneBox(before).low);
  std::set<uint32_t> keys;
  bool moved = false;
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    keys.insert(instance.key);
    moved |= instance.key != before.instances[i].key;
    const Instance& old = before.instances.at(instance.key);
    EXPECT_EQ(old.toWorld, instance.toWorld);
    const Mesh &mesh = scene.meshes.at(instance.mesh), &source = before.meshes.at(old.mesh);
    EXPECT_EQ(mesh.key, source.key);
    for (size_t t = 0; t < mesh.triangleCount(); ++t)
      for (size_t c = 0; c < 3; ++c)
        ASSERT_EQ(mesh.indices[3 * t + c], source.indices[3 * mesh.triangleKeys[t] + c]);
  }
  EXPECT_TRUE(moved);
  EXPECT_EQ(keys.size(), before.instances.size());
  Scene again = before;
  permuteScene(again, 5);
  EXPECT_EQ(again.meshes[0].indices, scene.meshes[0].indices);
}

TEST(Transform, DuplicatesOpaqueTrianglesOnly) {
  Scene scene = makeScene("layers");
  duplicateOpaque(scene);
  for (const Mesh& mesh : scene.meshes) {
    EXPECT_EQ(mesh.triangleCount(), mesh.name == "receiver" ? 4u : 2u) << mesh.name;
    EXPECT_EQ(std::set<uint32_t>(mesh.triangleKeys.begin(), mesh.triangleKeys.end()).size(),
              mesh.triangleCount());
  }
}

TEST(Transform, InsertedTrianglesHaveNoAreaAndAreFoundAgain) {
  Scene scene = makeScene("teapot:segments=3");
  const Scene before = scene;
  insertDegenerate(scene);
  for (size_t m = 0; m < scene.meshes.size(); ++m) {
    Mesh& mesh = scene.meshes[m];
    EXPECT_EQ(mesh.triangleCount(), before.meshes[m].triangleCount() + 3);
    EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_EQ(mesh.triangleKeys.size(), mesh.triangleCount());
    EXPECT_EQ(mesh.uv0.size(), mesh.uv0.empty() ? 0 : mesh.positions.size());
    EXPECT_GE(dropDegenerate(mesh), 2u);
  }
}

}  // namespace
}  // namespace sb
