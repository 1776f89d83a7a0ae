#include "suites/scenes/edit/scene_edit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/number.h"
#include "base/pattern.h"
#include "base/text.h"
#include "suites/scenes/edit/camera_path.h"
#include "suites/scenes/edit/framing.h"
#include "techniques/plan/error.h"
#include "techniques/scene/box.h"
#include "techniques/scene/placed_scene.h"

namespace sb {
namespace {

glm::dvec3 vectorOf(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

// The chosen camera comes first; the others keep their order.
void showCamera(Scene& scene, const SceneEdit& edit) {
  const std::string wanted = edit.name();
  std::vector<std::string> names;
  for (const Camera& camera : scene.cameras) names.push_back(camera.name);
  auto found = std::ranges::find(names, wanted);
  const auto index = base::readWhole(wanted, 0, std::numeric_limits<uint32_t>::max());
  if (found == names.end() && index) {
    if (*index >= names.size())
      throw InputError(edit.where(), "there is no camera " + wanted + ", the scene has " +
                                         std::to_string(names.size()) + ", counted from 0");
    found = names.begin() + std::ptrdiff_t(*index);
  }
  if (found == names.end())
    throw InputError(edit.where(), unknownName("camera", base::printable(wanted), names));
  const auto at = scene.cameras.begin() + (found - names.begin());
  std::rotate(scene.cameras.begin(), at, at + 1);
}

void editCamera(Scene& scene, const SceneEdit& edit) {
  if (!edit.names.empty()) return showCamera(scene, edit);
  const glm::dvec3 eye = vectorOf(*edit.find("eye")), at = vectorOf(*edit.find("at"));
  if (eye == at) throw InputError(edit.where(), "eye and at are the same point");
  const Box bounds = sceneBox(scene);
  const double farthest =
      bounds.empty() ? 1000 : glm::length(bounds.center() - eye) + bounds.radius();
  Camera camera;
  camera.name = "edit";
  camera.toWorld = lookFrom(eye, at);
  if (const auto* fov = edit.find("fov")) camera.fovY = (*fov)[0] * std::numbers::pi / 180;
  camera.farPlane = farthest * 1.01;
  camera.nearPlane = camera.farPlane * 1e-4;
  scene.cameras.insert(scene.cameras.begin(), camera);
  std::erase(scene.warnings, kCameraAdded);
}

void editSun(Scene& scene, const SceneEdit& edit) {
  const glm::dvec3 direction = vectorOf(*edit.find("direction"));
  if (glm::length(direction) == 0) throw InputError(edit.where(), "the direction has no length");
  Light light = defaultLight();
  light.name = "sun";
  light.direction = glm::normalize(direction);
  if (const auto* lux = edit.find("lux")) light.intensity = float((*lux)[0]);
  scene.lights = {light};
  // The sky came with the sun that is replaced; the file's own stays.
  if (std::erase(scene.warnings, kLightAdded) > 0) scene.sky = glm::vec3(0);
}

void editMotion(Scene& scene, const SceneEdit& edit, uint32_t steps) {
  const auto* way = edit.find("move");
  const auto* turn = edit.find("turn");
  if (!way && !turn) return;  // something else moves
  const glm::dvec3 move = way ? vectorOf(*way) : glm::dvec3(0);
  const double degrees = turn ? (*turn)[0] : 0;
  if (move == glm::dvec3(0) && degrees == 0)
    throw InputError(edit.where(), "the camera neither moves nor turns");
  moveCamera(scene, cameraPath(scene.camera().toWorld, move, degrees, steps));
}

void editMaterials(Scene& scene, const SceneEdit& edit) {
  size_t matched = 0;
  std::vector<std::string> names;
  const base::Pattern wanted = base::Pattern::glob(edit.target);
  for (Material& m : scene.materials) {
    names.push_back(m.name);
    if (!wanted.found(m.name)) continue;
    ++matched;
    m.opticsOverride = true;
    m.overrideAlpha = float((*edit.find("alpha"))[0]);
    const auto* t = edit.find("t");
    m.overrideTransmission = t ? glm::vec3(vectorOf(*t)) : glm::vec3(0);
  }
  if (matched == 0) throw InputError(edit.where(), unknownName("material", edit.target, names));
}

}  // namespace

uint32_t motionSteps(const std::vector<SceneEdit>& edits) {
  double steps = 8;
  for (const SceneEdit& edit : edits) {
    const auto* given = edit.target == "motion" ? edit.find("steps") : nullptr;
    if (given) steps = (*given)[0];
    if (steps != std::floor(steps))
      throw InputError(edit.where(),
                       "steps holds '" + base::numberText(steps) + "', expected a whole number");
  }
  return uint32_t(steps);
}

void requireMotion(const Scene& scene, const std::vector<SceneEdit>& edits) {
  for (const SceneEdit& edit : edits)
    if (edit.target == "motion" && scene.path.empty())
      throw InputError(edit.where(), "lacks move or turn: nothing else in the scene moves");
}

GltfOptions fileOptions(const std::vector<SceneEdit>& edits, bool isFile) {
  GltfOptions options{.scene = {}, .animation = {}, .steps = motionSteps(edits)};
  for (const SceneEdit& edit : edits) {
    if (edit.target != "file" && edit.target != "motion") continue;
    if (!edit.names.empty()) {
      if (!isFile) throw InputError(edit.where(), "is of glTF files, but the scene is none");
      if (edit.target == "file")
        options.scene = edit.name();
      else
        options.animation = edit.name();
    }
    if (const auto* outside = edit.find("outside")) options.allowOutside = (*outside)[0] != 0;
  }
  return options;
}

void applyEdits(Scene& scene, const std::vector<SceneEdit>& edits) {
  // Cameras see what is added, wherever it stands in the list.
  for (const SceneEdit& edit : edits)
    if (edit.target == "ground") addGround(scene, (*edit.find("size"))[0]);
  for (const SceneEdit& edit : edits) {
    if (edit.target == "ground" || edit.target == "file") continue;
    if (edit.target == "camera")
      editCamera(scene, edit);
    else if (edit.target == "sun")
      editSun(scene, edit);
    else if (edit.target == "motion")
      continue;
    else
      editMaterials(scene, edit);
  }
  // The way leads to where the camera stands in the end, wherever the edit stands in the list.
  for (const SceneEdit& edit : edits)
    if (edit.target == "motion") editMotion(scene, edit, motionSteps(edits));
}

}  // namespace sb
