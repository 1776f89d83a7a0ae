// What the user chooses about a file: camera, scene, ground; and what a file that lacks camera,
// light or background gets.
#include <cmath>

#include "base/percent.h"
#include "suites/scenes/edit/framing.h"
#include "suites/scenes/edit/scene_edit.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/scene/box.h"
#include "tests/scenes/gltf_files.h"

namespace sb::test {
namespace {

class GltfChoices : public GltfFiles {
 protected:
  Scene make(const json& gltf, const std::string& edit, const std::string& name = "test.gltf") {
    const std::string spec = file(gltf.dump(), name).string();
    return makeScene(edit.empty() ? spec : withEdit(spec, edit));
  }
  void expectRefused(const json& gltf, const std::string& edit, const std::string& part) {
    try {
      make(gltf, edit);
      ADD_FAILURE() << "made; expected an error with '" << part << "'";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    }
  }
};

TEST_F(GltfChoices, CamerasByNameAndNumber) {
  const json gltf = camerasAndLightsFile();
  const Scene first = make(gltf, "");
  EXPECT_EQ(first.camera().name, "front");
  EXPECT_TRUE(warns(first, "holds 2 cameras; the picture shows 'front'"));
  for (const char* chosen : {"camera:show=plan", "camera:show=1"}) {
    const Scene scene = make(gltf, chosen);
    EXPECT_EQ(scene.camera().name, "plan");
    EXPECT_EQ(scene.cameras.size(), 2u);
    EXPECT_TRUE(warns(scene, "the picture shows 'plan'"));
  }
  expectRefused(gltf, "camera:show=2", "has 2");
  expectRefused(gltf, "camera:show=plam", "did you mean");
  // Any name, also one that would end the edit.
  json odd = gltf;
  odd["cameras"][1]["name"] = "a;b,c=d?e:%";
  const std::string edit = "camera:show=" + base::percentEncoded("a;b,c=d?e:%");
  EXPECT_EQ(make(odd, edit).camera().orthographic, true);
  EXPECT_EQ(canonicalEdits(parseEdits(edit)), edit);
}

TEST_F(GltfChoices, ScenesByNameAndNumber) {
  json gltf = triangleFile();
  gltf["nodes"].push_back({{"mesh", 0}, {"name", "other"}});
  gltf["scenes"].push_back({{"name", "second"}, {"nodes", {1}}});
  EXPECT_TRUE(warns(make(gltf, ""), "the picture shows scenes[0]"));
  for (const char* chosen : {"file:scene=second", "file:scene=1"}) {
    const Scene scene = make(gltf, chosen);
    EXPECT_EQ(scene.instances.at(0).name, "other");
    EXPECT_TRUE(warns(scene, "the picture shows scenes[1] 'second'"));
  }
  expectRefused(gltf, "file:scene=2", "the file holds 2");
  expectRefused(gltf, "file:scene=sekond", "did you mean second");
  EXPECT_THROW(makeScene("layers?file:scene=1"), InputError);
}

TEST_F(GltfChoices, FileNamesMayHoldQuestionMarks) {
  const Scene scene = make(triangleFile(), "", "what?.glb?really.gltf");
  EXPECT_EQ(scene.instances.size(), 1u);
  const Scene sunny = make(triangleFile(), "sun:direction=0,-1,0", "what?.glb?really.gltf");
  EXPECT_EQ(sunny.lights.at(0).name, "sun");
  EXPECT_EQ(canonicalSceneSpec("no?such.glb?sun:direction=0,-1,0"),
            "no?such.glb?sun:direction=0,-1,0");
}

/// Box of the scene's vertices in the picture of a camera, -1..1 both ways at aspect 1.
Box pictureBox(const Scene& scene) {
  const Camera& camera = scene.camera();
  const glm::dmat4 toView = glm::inverse(camera.toWorld);
  Box box;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    if (mesh.name == "ground") continue;
    for (const uint32_t i : mesh.indices) {
      const glm::dvec4 p = toView * instance.toWorld * glm::dvec4(glm::dvec3(mesh.positions[i]), 1);
      EXPECT_GT(-p.z, camera.nearPlane);
      EXPECT_LT(-p.z, camera.farPlane);
      const double scale = 1 / (std::tan(0.5 * camera.fovY) * -p.z);
      box.add({p.x * scale, p.y * scale, 0});
    }
  }
  return box;
}

TEST_F(GltfChoices, FramingFillsFourFifths) {
  const std::vector<std::vector<float>> shapes = {
      {0, 0, 0, 1, 0, 0, 0, 1, 0},           // small
      {0, 0, 0, 1000, 0, 0, 0, 1, 0},        // wide
      {0, 0, 0, 0.001f, 0, 0, 0, 5, 0},      // high
      {-3, 0, -900, 3, 0, -900, 0, 0, 900},  // deep
      {1e6f, 1e6f, 0, 1000001, 1e6f, 0, 1e6f, 1000001, 0}};
  for (const auto& shape : shapes) {
    json gltf = triangleFile();
    gltf["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = addFloats(gltf, shape, 3);
    const Box box = pictureBox(make(gltf, ""));
    EXPECT_NEAR(std::max(box.high.x - box.low.x, box.high.y - box.low.y), 1.6, 1e-6);
    // The side that decides is centred; the other lies within the same four fifths.
    for (int i = 0; i < 2; ++i) {
      EXPECT_GE(box.low[i], -0.8 - 1e-6);
      EXPECT_LE(box.high[i], 0.8 + 1e-6);
    }
  }
}

TEST_F(GltfChoices, AGroundReceivesAndIsSeen) {
  const Scene bare = make(triangleFile(), ""), scene = make(triangleFile(), "ground:size=4");
  ASSERT_EQ(scene.instances.size(), 2u);
  const Box ground = instanceBox(scene, scene.instances[1]);
  EXPECT_LT(ground.high.y, 0);
  EXPECT_GT(ground.high.y, -0.01);
  EXPECT_EQ(scene.camera().toWorld, bare.camera().toWorld);
  for (int i = 0; i < 8; ++i)
    EXPECT_LT(glm::length(ground.corner(i) - scene.camera().eye()), scene.camera().farPlane);
  EXPECT_NE(scene.instances[0].key, scene.instances[1].key);
  EXPECT_NE(scene.meshes[0].key, scene.meshes[1].key);
}

TEST_F(GltfChoices, DaylightForFilesWithoutLight) {
  const Scene bare = make(triangleFile(), "");
  EXPECT_EQ(bare.lights.size(), 1u);
  EXPECT_GT(bare.sky.y, 0);
  EXPECT_EQ(bare.background, kNeutralBackground);
  EXPECT_TRUE(warns(bare, "a sun and a sky were added"));
  // White that faces the sun stays within the picture.
  EXPECT_LT(bare.lights[0].intensity / M_PI + bare.ambient.y + bare.sky.y, 1.001);
  const Scene lit = make(camerasAndLightsFile(), "");
  EXPECT_EQ(lit.lights.size(), 3u);
  EXPECT_EQ(lit.sky, glm::vec3(0));
  EXPECT_EQ(make(triangleFile(), "sun:direction=0,-1,0").sky, glm::vec3(0));
  json gltf = triangleFile();
  gltf["scenes"][0]["extras"]["shadowbench"] = {{"background", {0, 0, 0}}, {"sky", {0, 0, 1}}};
  EXPECT_EQ(make(gltf, "").background, glm::vec3(0));
}

}  // namespace
}  // namespace sb::test
