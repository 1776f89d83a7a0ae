#include "tests/fuzz/oracle.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "suites/scenes/gltf/loader.h"
#include "suites/scenes/gltf/write/export.h"
#include "techniques/plan/error.h"

namespace sb::fuzz {
namespace {

template <class V>
bool allFinite(const std::vector<V>& values) {
  for (const V& v : values)
    for (int c = 0; c < V::length(); ++c)
      if (!std::isfinite(v[c])) return false;
  return true;
}

std::string meshFault(const Scene& scene, const Mesh& mesh) {
  const size_t n = mesh.positions.size();
  if (mesh.material >= scene.materials.size()) return "a mesh's material is not there";
  if (mesh.normals.size() != n) return "normals are missing";
  const bool mapped = scene.materials[mesh.material].normalTexture.present();
  if (mesh.tangents.size() != (mapped ? n : 0)) return "tangents are missing or too many";
  for (const size_t size : {mesh.uv0.size(), mesh.uv1.size(), mesh.colors.size()})
    if (size != 0 && size != n) return "attributes differ in length";
  if (mesh.indices.empty() || mesh.triangleKeys.size() * 3 != mesh.indices.size())
    return "indices and keys disagree";
  for (const uint32_t i : mesh.indices)
    if (i >= n) return "an index beyond the vertices";
  if (!allFinite(mesh.positions) || !allFinite(mesh.normals) || !allFinite(mesh.tangents) ||
      !allFinite(mesh.uv0) || !allFinite(mesh.uv1) || !allFinite(mesh.colors))
    return "an attribute is not finite";
  return "";
}

std::string sceneFault(const Scene& scene) {
  if (scene.cameras.empty() || scene.lights.empty()) return "no camera or no light";
  for (const Mesh& mesh : scene.meshes)
    if (const std::string fault = meshFault(scene, mesh); !fault.empty()) return fault;
  for (const Instance& i : scene.instances) {
    if (i.mesh >= scene.meshes.size()) return "an instance's mesh is not there";
    for (int k = 0; k < 16; ++k)
      if (!std::isfinite(float(i.toWorld[k / 4][k % 4]))) return "a transform is not finite";
    if (i.name != base::printable(i.name)) return "a name is not printable";
  }
  for (const Material& m : scene.materials)
    if (!std::isfinite(glm::dot(m.baseColor, glm::vec4(1))) ||
        !std::isfinite(m.emissive.r + m.emissive.g + m.emissive.b) || !std::isfinite(m.thickness))
      if (glm::any(glm::isnan(m.baseColor)) || glm::any(glm::isinf(m.baseColor)) ||
          glm::any(glm::isnan(m.emissive)) || glm::any(glm::isinf(m.emissive)))
        return "a material's colour is not finite";
  for (const Light& l : scene.lights)
    if (!std::isfinite(l.intensity) || !(std::abs(glm::length(l.direction) - 1) < 1e-6))
      return "a light without sense";
  for (const Camera& c : scene.cameras)
    if (!(c.farPlane > c.nearPlane) || !std::isfinite(float(c.farPlane)))
      return "a camera without depth";
  for (const Image& i : scene.images)
    if (i.rgba.size() != size_t(i.width) * i.height * 4) return "an image of another size";
  for (const std::string& w : scene.warnings)
    if (w.size() > 300 || w != base::printable(w)) return "a warning unfit for a terminal: " + w;
  return "";
}

std::string roundTripFault(const Scene& scene, const std::filesystem::path& path) {
  Scene back;
  try {
    exportGlb(scene, path);
    back = loadGltf(path);
  } catch (const InputError& e) {
    const std::string text = e.what();
    if (text.find("shears") != text.npos) return "";  // documented
    return "what was exported is refused: " + text;
  }
  if (back.meshes.size() != scene.meshes.size() ||
      back.instances.size() != scene.instances.size() ||
      back.lights.size() != scene.lights.size() || back.cameras.size() != scene.cameras.size() ||
      back.images.size() != scene.images.size() || back.materials.size() != scene.materials.size())
    return "what was exported comes back as something else";
  for (size_t i = 0; i < scene.meshes.size(); ++i)
    if (back.meshes[i].positions != scene.meshes[i].positions ||
        back.meshes[i].indices != scene.meshes[i].indices)
      return "an exported mesh comes back as another";
  if (back.ambient != scene.ambient || back.sky != scene.sky || back.background != scene.background)
    return "surroundings come back as others";
  return "";
}

std::string refusalFault(const std::string& text) {
  if (text.size() > 300) return "an error of " + std::to_string(text.size());
  if (text != base::printable(text)) return "an error unfit for a terminal";
  for (const char* vague : {"cannot be read: ", "tinygltf: "})
    if (text.find(vague) != text.npos) return "names no field: " + text;
  return "";
}

/// Of a file with an animation, which may be broken or play.
std::string playFault(const std::filesystem::path& path) try {
  const Scene scene = loadGltf(path, {.scene = {}, .animation = "0", .steps = 3});
  if (scene.path.size() != 3) return "an animation plays in other steps than asked for";
  for (const SceneState& state : scene.path)
    for (const auto* list : {&state.cameras, &state.instances})
      for (const glm::dmat4& m : *list)
        for (int i = 0; i < 16; ++i)
          if (!std::isfinite(m[i / 4][i % 4])) return "an animation goes where no number is";
  return "";
} catch (const InputError& e) {
  return refusalFault(e.what());
}

}  // namespace

Verdict judge(const std::filesystem::path& path, const std::filesystem::path& exported) {
  Scene scene;
  try {
    scene = loadGltf(path);
  } catch (const InputError& e) {
    const std::string fault = refusalFault(e.what());
    return {fault.empty() ? Outcome::Refused : Outcome::Fault, fault};
  }
  std::string fault = sceneFault(scene);
  const auto ofAnimation = [](const std::string& w) { return w.ends_with("is shown at t = 0"); };
  if (fault.empty() && std::ranges::any_of(scene.warnings, ofAnimation)) fault = playFault(path);
  if (fault.empty() && !exported.empty()) fault = roundTripFault(scene, exported);
  if (!fault.empty()) return {Outcome::Fault, fault};
  return {Outcome::Loaded, ""};
}

}  // namespace sb::fuzz
