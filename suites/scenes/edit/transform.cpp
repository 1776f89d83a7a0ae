#include "suites/scenes/edit/transform.h"

#include <algorithm>
#include <numeric>

#include "suites/scenes/procedural/parts/random.h"
#include "techniques/scene/optics.h"

namespace sb {
namespace {

// order[new place] = old place, by Fisher and Yates.
std::vector<uint32_t> shuffledOrder(size_t count, Pcg& random) {
  std::vector<uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  for (size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(uint32_t(i))]);
  return order;
}

template <typename T>
void reorder(std::vector<T>& items, const std::vector<uint32_t>& order) {
  std::vector<T> moved;
  moved.reserve(items.size());
  for (const uint32_t from : order) moved.push_back(std::move(items[from]));
  items = std::move(moved);
}

void permuteTriangles(Mesh& mesh, Pcg& random) {
  const std::vector<uint32_t> order = shuffledOrder(mesh.triangleCount(), random);
  const std::vector<uint32_t> indices = mesh.indices, keys = mesh.triangleKeys;
  for (size_t t = 0; t < order.size(); ++t) {
    for (size_t c = 0; c < 3; ++c) mesh.indices[3 * t + c] = indices[3 * order[t] + c];
    mesh.triangleKeys[t] = keys[order[t]];
  }
}

uint32_t nextKey(const Mesh& mesh) {
  const auto largest = std::ranges::max_element(mesh.triangleKeys);
  return largest == mesh.triangleKeys.end() ? 0 : *largest + 1;
}

void addTriangle(Mesh& mesh, uint32_t a, uint32_t b, uint32_t c, uint32_t key) {
  mesh.indices.insert(mesh.indices.end(), {a, b, c});
  mesh.triangleKeys.push_back(key);
}

template <typename V>
void appendMiddle(std::vector<V>& attribute, uint32_t a, uint32_t b) {
  if (!attribute.empty()) attribute.push_back((attribute[a] + attribute[b]) * 0.5f);
}

}  // namespace

void translateScene(Scene& scene, glm::dvec3 offset) {
  const auto move = [&](glm::dmat4& m) { m[3] += glm::dvec4(offset, 0); };
  for (Instance& instance : scene.instances) move(instance.toWorld);
  for (Medium& medium : scene.media) move(medium.boxToWorld);
  for (Camera& camera : scene.cameras) move(camera.toWorld);
  for (Light& light : scene.lights) light.position += offset;
  for (SceneState& step : scene.path) {
    for (auto* list : {&step.cameras, &step.instances})
      for (glm::dmat4& toWorld : *list) move(toWorld);
    for (LightPose& pose : step.lights) pose.position += offset;
  }
}

void scaleScene(Scene& scene, double factor) {
  const auto scaleAll = [&](glm::dmat4& m) {
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row) m[column][row] *= factor;
  };
  for (Instance& instance : scene.instances) scaleAll(instance.toWorld);
  for (Medium& medium : scene.media) {
    scaleAll(medium.boxToWorld);
    medium.extinction /= float(factor);
  }
  const auto scalePlace = [&](glm::dmat4& m) {  // a camera's frame stays rigid
    for (int row = 0; row < 3; ++row) m[3][row] *= factor;
  };
  for (Camera& camera : scene.cameras) {
    scalePlace(camera.toWorld);
    camera.nearPlane *= factor;
    camera.farPlane *= factor;
    camera.halfHeight *= factor;
  }
  for (Light& light : scene.lights) {
    light.position *= factor;
    if (light.type == LightType::Directional) continue;  // its radius is an angle
    light.range *= factor;
    light.halfAxes *= factor;
    light.intensity *= float(factor * factor);
  }
  for (SceneState& step : scene.path) {
    for (glm::dmat4& toWorld : step.cameras) scalePlace(toWorld);
    for (glm::dmat4& toWorld : step.instances) scaleAll(toWorld);
    for (LightPose& pose : step.lights) {
      pose.position *= factor;
      pose.halfAxes *= factor;
    }
  }
  for (Material& material : scene.materials) {
    material.thickness *= float(factor);
    material.attenuationDistance *= float(factor);
  }
}

void permuteScene(Scene& scene, uint64_t seed) {
  Pcg random(seed, 3);
  for (Mesh& mesh : scene.meshes) permuteTriangles(mesh, random);
  const std::vector<uint32_t> meshes = shuffledOrder(scene.meshes.size(), random);
  std::vector<uint32_t> placeOf(meshes.size());
  for (size_t i = 0; i < meshes.size(); ++i) placeOf[meshes[i]] = uint32_t(i);
  reorder(scene.meshes, meshes);
  for (Instance& instance : scene.instances) instance.mesh = placeOf[instance.mesh];
  reorder(scene.instances, shuffledOrder(scene.instances.size(), random));
  reorder(scene.lights, shuffledOrder(scene.lights.size(), random));
}

void duplicateOpaque(Scene& scene) {
  std::vector<uint8_t> opaque;
  for (const Material& material : scene.materials)
    opaque.push_back(materialTraits(scene, material).lightClass == MaterialClass::Opaque);
  for (Mesh& mesh : scene.meshes) {
    if (!opaque.at(mesh.material)) continue;
    const uint32_t count = mesh.triangleCount(), key = nextKey(mesh);
    for (uint32_t t = 0; t < count; ++t)
      addTriangle(mesh, mesh.indices[3 * t], mesh.indices[3 * t + 1], mesh.indices[3 * t + 2],
                  key + t);
  }
}

void insertDegenerate(Scene& scene) {
  for (Mesh& mesh : scene.meshes) {
    if (mesh.indices.empty()) continue;
    const uint32_t a = mesh.indices[0], b = mesh.indices[1], key = nextKey(mesh);
    const uint32_t middle = uint32_t(mesh.positions.size());
    appendMiddle(mesh.positions, a, b);
    mesh.normals.push_back(mesh.normals[a]);
    if (!mesh.tangents.empty()) mesh.tangents.push_back(mesh.tangents[a]);
    appendMiddle(mesh.uv0, a, b);
    appendMiddle(mesh.uv1, a, b);
    appendMiddle(mesh.colors, a, b);
    addTriangle(mesh, a, a, b, key);
    addTriangle(mesh, a, middle, b, key + 1);
    addTriangle(mesh, b, b, b, key + 2);
  }
}

}  // namespace sb
