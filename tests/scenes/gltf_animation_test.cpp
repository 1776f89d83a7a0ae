// Animations of glTF files that play: places at each step worked out by hand, what follows which
// node, what stays, and what is refused.
#include <cmath>
#include <numbers>

#include "suites/scenes/procedural/procedural.h"
#include "techniques/scene/placed_scene.h"
#include "tests/scenes/gltf_files.h"

namespace sb::test {
namespace {

class GltfAnimation : public GltfFiles {
 protected:
  Scene play(const json& gltf, uint32_t steps = 5, const std::string& which = "0") {
    return loadGltf(file(gltf.dump()), {.scene = {}, .animation = which, .steps = steps});
  }
  void expectRefused(const json& gltf, const std::vector<std::string>& parts,
                     const std::string& which = "0") {
    try {
      play(gltf, 5, which);
      ADD_FAILURE() << "loaded; expected an error with '" << parts.front() << "'";
    } catch (const InputError& e) {
      for (const std::string& part : parts)
        EXPECT_NE(std::string(e.what()).find(part), std::string::npos)
            << e.what() << "\n  lacks: " << part;
    }
  }
};

/// A channel that sets `path` of `node` at `times`.
void animate(json& gltf, size_t node, const std::string& path, const std::vector<float>& times,
             const std::vector<float>& values, const std::string& interpolation = "") {
  if (!gltf.contains("animations"))
    gltf["animations"] = json::parse(R"([{"channels": [], "samplers": []}])");
  json& animation = gltf["animations"][0];
  json sampler = {{"input", addFloats(gltf, times, 1)},
                  {"output", addFloats(gltf, values, path == "rotation" ? 4 : 3)}};
  if (!interpolation.empty()) sampler["interpolation"] = interpolation;
  animation["channels"].push_back(
      {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
  animation["samplers"].push_back(sampler);
}

glm::dvec3 placeAt(const Scene& scene, uint32_t step, uint32_t instance = 0) {
  return glm::dvec3(PlacedScene(scene, step).toWorld(instance)[3]);
}

void expectNear(const glm::dvec3& a, const glm::dvec3& b) {
  EXPECT_NEAR(glm::length(a - b), 0, 1e-6)
      << a.x << " " << a.y << " " << a.z << ", expected " << b.x << " " << b.y << " " << b.z;
}

const float kHalf = float(std::sqrt(0.5));  // sine and cosine of half a right angle

/// A node that turns by a right angle about z, from 0 to 4 s, and the triangle's node below it.
json turningFile() {
  json gltf = triangleFile();
  gltf["nodes"].push_back({{"children", {0}}, {"translation", {0, 0, 5}}});
  gltf["scenes"][0]["nodes"] = {1};
  animate(gltf, 1, "rotation", {0, 4}, {0, 0, 0, 1, 0, 0, kHalf, kHalf});
  return gltf;
}

TEST_F(GltfAnimation, ChildrenFollowTheirParents) {
  json gltf = turningFile();
  animate(gltf, 0, "translation", {0, 2}, {1, 0, 0, 2, 0, 0}, "STEP");
  const Scene scene = play(gltf);
  ASSERT_EQ(scene.path.size(), 5u);
  const double eighth = std::numbers::pi / 8;
  for (uint32_t k = 0; k < 5; ++k) {
    const double far = k < 2 ? 1 : 2;  // the step is taken at 2 s
    expectNear(placeAt(scene, k), {far * std::cos(k * eighth), far * std::sin(k * eighth), 5});
    expectNear(glm::dvec3(PlacedScene(scene, k).toWorld(0)[1]),
               {-std::sin(k * eighth), std::cos(k * eighth), 0});
  }
  EXPECT_EQ(scene.instances[0].toWorld, PlacedScene(scene, 4).toWorld(0));
  EXPECT_EQ(scene.camera().pose, kNone);
}

TEST_F(GltfAnimation, SplinesFollowTheirTangents) {
  json gltf = triangleFile();
  // Keys of incoming tangent, value, outgoing tangent; tangents are per second.
  animate(gltf, 0, "scale", {0, 4}, {9, 9, 9, 1, 1, 1, 2, 0, 0, 0, 0, 0, 3, 1, 1, 9, 9, 9},
          "CUBICSPLINE");
  const Scene scene = play(gltf);
  const double widths[] = {1, 2.4375, 3, 3.0625, 3};
  for (uint32_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(PlacedScene(scene, k).toWorld(0)[0].x, widths[k], 1e-6) << k;
    EXPECT_NEAR(PlacedScene(scene, k).toWorld(0)[1].y, 1, 1e-6) << k;
  }
}

TEST_F(GltfAnimation, TurnsTakeTheShorterWayAndKeysHoldBeforeAndBehind) {
  json gltf = triangleFile();
  // The same turn about z as its negative quaternion, from 1 to 3 s of 4.
  animate(gltf, 0, "rotation", {1, 3}, {0, 0, 0, 1, 0, 0, -kHalf, -kHalf});
  animate(gltf, 0, "translation", {0, 4}, {0, 0, 0, 4, 0, 0});
  const Scene scene = play(gltf);
  const double degrees[] = {0, 0, 45, 90, 90};
  for (uint32_t k = 0; k < 5; ++k) {
    const double a = degrees[k] * std::numbers::pi / 180;
    expectNear(glm::dvec3(PlacedScene(scene, k).toWorld(0)[0]), {std::cos(a), std::sin(a), 0});
    expectNear(placeAt(scene, k), {k, 0, 0});
  }
}

TEST_F(GltfAnimation, LightsAndCamerasGoWithTheirNodes) {
  json gltf = camerasAndLightsFile();
  const size_t nodes = gltf["nodes"].size();
  gltf["nodes"].push_back({{"camera", 0}});
  gltf["nodes"].push_back({{"camera", 1}});
  gltf["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  gltf["scenes"][0]["nodes"] = {0, nodes, nodes + 1, nodes + 2};
  // All turn about y by a right angle, and the second camera moves too.
  for (size_t n = nodes; n < nodes + 3; ++n)
    animate(gltf, n, "rotation", {0, 1}, {0, 0, 0, 1, 0, kHalf, 0, kHalf});
  animate(gltf, nodes + 1, "translation", {0, 1}, {0, 0, 0, 4, 0, 0});
  const Scene scene = play(gltf, 2);
  ASSERT_EQ(scene.cameras.size(), 2u);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.instances[0].pose, kNone);
  const PlacedScene first(scene, 0), last(scene, 1);
  expectNear(first.light(0).direction, {0, 0, -1});
  expectNear(last.light(0).direction, {-1, 0, 0});
  expectNear(scene.lights[0].direction, {-1, 0, 0});
  expectNear(-glm::dvec3(first.camera().toWorld[2]), {0, 0, -1});
  expectNear(-glm::dvec3(last.camera().toWorld[2]), {-1, 0, 0});
  EXPECT_EQ(scene.path[0].cameras[scene.cameras[1].pose][3].x, 0);
  EXPECT_EQ(scene.path[1].cameras[scene.cameras[1].pose][3].x, 4);
  EXPECT_EQ(scene.cameras[1].toWorld[3].x, 4);
}

TEST_F(GltfAnimation, ShapesStay) {
  json gltf = morphedFile();
  animate(gltf, 0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0});
  json& animation = gltf["animations"][0];
  animation["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "weights"}}}});
  animation["samplers"].push_back(
      {{"input", addFloats(gltf, {0, 1}, 1)}, {"output", addFloats(gltf, {1, 0, 0, 1}, 1)}});
  const Scene scene = play(gltf, 3);
  EXPECT_TRUE(warns(scene, "morph targets keep the shape that they have at t = 0"));
  EXPECT_EQ(scene.meshes[0].positions[0], glm::vec3(0, 0, 1));
  expectNear(placeAt(scene, 1), {0.5, 0, 0});
  json skinned = skinnedFile();
  skinned["nodes"].push_back({{"mesh", 0}});
  const size_t node = skinned["nodes"].size() - 1;
  skinned["scenes"][0]["nodes"].push_back(node);
  animate(skinned, node, "translation", {0, 1}, {0, 0, 0, 1, 0, 0});
  const Scene bent = play(skinned, 2);
  EXPECT_TRUE(warns(bent, "skinned meshes keep the shape and place"));
  ASSERT_EQ(bent.instances.size(), 2u);
  EXPECT_EQ(bent.instances[0].pose, kNone);
  EXPECT_NE(bent.instances[1].pose, kNone);
}

TEST_F(GltfAnimation, PlaysWhenAskedAlone) {
  const json gltf = turningFile();
  EXPECT_TRUE(load(gltf).path.empty());
  const std::string path = file(gltf.dump(), "turn.gltf").string();
  EXPECT_TRUE(makeScene(path).path.empty());
  const Scene both = makeScene(path + "?motion:animation=0,move=1,0,0,steps=3");
  ASSERT_EQ(both.path.size(), 3u);
  EXPECT_NE(both.camera().pose, kNone);
  EXPECT_NE(both.instances[0].pose, kNone);
  EXPECT_EQ(makeScene(path + "?motion:animation=0").path.size(), 8u);
  EXPECT_THROW(makeScene(path + "?motion:steps=3"), InputError);
  EXPECT_THROW(makeScene("layers?motion:animation=0"), InputError);
}

TEST_F(GltfAnimation, AnimationsAreFoundByNameOrNumber) {
  json gltf = animatedFile();
  gltf["animations"].push_back(gltf["animations"][0]);
  gltf["animations"][1]["name"] = "run";
  gltf["animations"][1]["samplers"][0]["output"] = addFloats(gltf, {0, 0, 0, 0, 0, 8}, 3);
  for (const char* which : {"run", "1"}) {
    const Scene scene = play(gltf, 3, which);
    expectNear(placeAt(scene, 0), {0, 0, 0});
    expectNear(placeAt(scene, 1), {0, 0, 0});  // at 1 s, where it begins
    expectNear(placeAt(scene, 2), {0, 0, 8});
    EXPECT_TRUE(warns(scene, "holds 2 animations; animations[1] 'run' plays"));
  }
  expectRefused(gltf, {"animations", "'runs'", "run"}, "runs");
  expectRefused(gltf, {"animations", "there is no number 2", "holds 2"}, "2");
  expectRefused(triangleFile(), {"animations", "missing"});
}

TEST_F(GltfAnimation, BrokenOnesAreRefused) {
  const auto broken = [&](const char* pointer, const json& value,
                          const std::vector<std::string>& parts) {
    json gltf = animatedFile();
    gltf["animations"][0][json::json_pointer(pointer)] = value;
    expectRefused(gltf, parts);
  };
  broken("/channels/0/target/node", 7, {"animations[0].channels[0].target.node", "7"});
  broken("/channels/0/target/path", "colour",
         {"animations[0].channels[0].target.path", "colour", "expected translation"});
  broken("/samplers/0/interpolation", "SMOOTH",
         {"animations[0].samplers[0].interpolation", "SMOOTH", "CUBICSPLINE"});
  broken("/samplers/0/interpolation", "CUBICSPLINE",
         {"animations[0].samplers[0].output", "2 elements", "expected 6 for 2 keys"});
  broken("/samplers/0/input", 99, {"animations[0].samplers[0].input", "99"});
  broken("/samplers/0/input", 0, {"animations[0].samplers[0].input", "3 components", "expected 1"});
  const auto times = [&](const std::vector<float>& of, const std::vector<std::string>& parts) {
    json gltf = animatedFile();
    gltf["animations"][0]["samplers"][0]["input"] = addFloats(gltf, of, 1);
    expectRefused(gltf, parts);
  };
  times({1, 1}, {"samplers[0].input", "element 1 is 1.0", "more than the 1.0 before it"});
  times({-1, 1}, {"samplers[0].input", "element 0 is -1.0", "no less than 0"});
  times({1, NAN}, {"samplers[0].input", "element 1", "finite"});
  times({1, 2, 3}, {"samplers[0].output", "2 elements", "expected 3 for 3 keys"});
  json still = animatedFile();
  still["animations"][0]["samplers"][0]["output"] = addFloats(still, {1, 1, 1, 1, 1, 1}, 3);
  expectRefused(still, {"animations", "move nothing"});
  json lit = camerasAndLightsFile();
  lit["nodes"].push_back({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  const size_t node = lit["nodes"].size() - 1;
  lit["scenes"][0]["nodes"] = {0, node};
  animate(lit, node, "scale", {0, 1}, {1, 1, 1, 0, 0, 0});
  expectRefused(lit, {"nodes[" + std::to_string(node) + "]", "scale 0 from the animation"});
}

}  // namespace
}  // namespace sb::test
