// The node tree: instances, lights, cameras and media with their place in the world, in double.
#include <cmath>

#include "suites/scenes/bounds.h"
#include "suites/scenes/gltf_context.h"
#include "suites/scenes/gltf_variants.h"

namespace sb {
namespace {

glm::dmat4 localTransform(GltfContext& context, const std::string& field,
                          const tinygltf::Node& node) {
  glm::dmat4 m(1);
  const bool parts = !node.translation.empty() || !node.rotation.empty() || !node.scale.empty();
  if (!node.matrix.empty()) {
    if (parts) context.warn(field + " has a matrix and other transforms: the matrix is used");
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = node.matrix[size_t(i)];
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1)
      context.fail(field + ".matrix", "has a last row other than 0, 0, 0, 1");
    return m;
  }
  if (!node.rotation.empty()) {
    const auto& r = node.rotation;
    const double length = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
    if (!(length > 1e-6 && std::isfinite(length)))
      context.fail(field + ".rotation", "has no length, expected a unit quaternion");
    if (std::abs(length - 1) > 1e-3)
      context.warn(field + ".rotation is not a unit quaternion; it was normalized");
    const double x = r[0] / length, y = r[1] / length, z = r[2] / length, w = r[3] / length;
    m[0] = {1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0};
    m[1] = {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0};
    m[2] = {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0};
  }
  if (!node.scale.empty())
    for (int i = 0; i < 3; ++i) m[i] *= node.scale[size_t(i)];
  if (!node.translation.empty())
    m[3] = {node.translation[0], node.translation[1], node.translation[2], 1};
  return m;
}

bool finite(const glm::dmat4& m) {
  for (int i = 0; i < 16; ++i)
    if (!std::isfinite(m[i / 4][i % 4])) return false;
  return true;
}

void addLight(GltfContext& context, const tinygltf::Value& reference, const glm::dmat4& toWorld) {
  const size_t index = size_t(reference.Get("light").GetNumberAsInt());
  const std::string field = fieldAt("extensions.KHR_lights_punctual.lights", index);
  const tinygltf::Light& source = context.model.lights[index];
  Light light;
  light.name = source.name.empty() ? "light" + std::to_string(index) : source.name;
  if (source.type == "directional")
    light.type = LightType::Directional;
  else if (source.type == "point")
    light.type = LightType::Point;
  else if (source.type == "spot")
    light.type = LightType::Spot;
  else
    context.fail(field + ".type", "is '" + source.type + "', expected directional, point or spot");
  for (int i = 0; i < 3 && source.color.size() == 3; ++i)
    light.color[i] = float(source.color[size_t(i)]);
  light.intensity = float(source.intensity);
  light.range = source.range;
  light.position = glm::dvec3(toWorld[3]);
  const glm::dvec3 direction = glm::dmat3(toWorld) * glm::dvec3(0, 0, -1);
  if (!(glm::length(direction) > 0)) context.fail(field, "has no direction: its node's scale is 0");
  light.direction = glm::normalize(direction);
  if (light.type == LightType::Spot) {
    light.innerCone = source.spot.innerConeAngle;
    light.outerCone = source.spot.outerConeAngle;
    if (!(light.innerCone < light.outerCone))
      context.fail(field + ".spot.innerConeAngle", "is " + shown(light.innerCone) +
                                                       ", expected less than outerConeAngle (" +
                                                       shown(light.outerCone) + ")");
  }
  light.radius = readLightRadius(context, field, source.extras);
  context.scene.lights.push_back(light);
}

// Without its scale, which glTF tells viewers to ignore.
glm::dmat4 rigid(const GltfContext& context, const std::string& field, const glm::dmat4& m) {
  const glm::dvec3 z = glm::normalize(glm::dvec3(m[2]));
  const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(m[1]), z));
  const glm::dmat4 frame(glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0), m[3]);
  if (!finite(frame)) context.fail(field, "holds a camera, but its scale is 0");
  return frame;
}

void addCamera(GltfContext& context, const std::string& node, int index,
               const glm::dmat4& toWorld) {
  const std::string field = fieldAt("cameras", size_t(index));
  const tinygltf::Camera& source = context.model.cameras[size_t(index)];
  Camera camera;
  camera.name = source.name.empty() ? "camera" + std::to_string(index) : source.name;
  camera.toWorld = rigid(context, node, toWorld);
  if (source.type == "perspective") {
    camera.fovY = source.perspective.yfov;
    if (camera.fovY >= 3.14159265358979)
      context.fail(field + ".perspective.yfov",
                   "is " + shown(camera.fovY) + ", expected less than pi");
    camera.nearPlane = source.perspective.znear;
    camera.farPlane = source.perspective.zfar;  // 0: endless; see closeFarPlanes
    if (camera.farPlane > 0 && camera.farPlane <= camera.nearPlane)
      context.fail(field + ".perspective.zfar", "is not beyond znear");
  } else if (source.type == "orthographic") {
    camera.orthographic = true;
    camera.halfHeight = std::abs(source.orthographic.ymag);
    camera.nearPlane = source.orthographic.znear;
    camera.farPlane = source.orthographic.zfar;
    if (!(camera.halfHeight > 0))
      context.fail(field + ".orthographic.ymag", "is 0, expected another number");
    if (camera.farPlane <= camera.nearPlane)
      context.fail(field + ".orthographic.zfar", "is not beyond znear");
  } else {
    context.fail(field + ".type", "is '" + source.type + "', expected perspective or orthographic");
  }
  context.scene.cameras.push_back(camera);
}

void closeFarPlanes(Scene& scene) {
  const Bounds box = sceneBox(scene);
  for (Camera& camera : scene.cameras) {
    if (camera.farPlane > 0) continue;
    camera.farPlane = 10 * camera.nearPlane;
    if (!box.empty())
      camera.farPlane = std::max(camera.farPlane,
                                 1.01 * (glm::length(box.center() - camera.eye()) + box.radius()));
  }
}

std::vector<int> rootNodes(GltfContext& context) {
  const tinygltf::Model& model = context.model;
  if (!model.scenes.empty()) {
    const size_t scene = size_t(std::max(model.defaultScene, 0));
    if (model.scenes.size() > 1)
      context.warn("the file holds " + std::to_string(model.scenes.size()) +
                   " scenes; the picture shows scenes[" + std::to_string(scene) + "]");
    readSceneExtras(context, fieldAt("scenes", scene), model.scenes[scene].extras);
    return model.scenes[scene].nodes;
  }
  std::vector<uint8_t> isChild(model.nodes.size());
  for (const tinygltf::Node& node : model.nodes)
    for (const int child : node.children) isChild[size_t(child)] = 1;
  std::vector<int> roots;
  for (size_t i = 0; i < model.nodes.size(); ++i)
    if (!isChild[i]) roots.push_back(int(i));
  if (!roots.empty()) context.warn("the file names no scene; all its nodes are shown");
  return roots;
}

void addInstances(GltfContext& context, const std::string& field, const std::string& name,
                  size_t mesh, const glm::dmat4& toWorld, Variants& variants) {
  Scene& scene = context.scene;
  if (context.meshes[mesh].empty()) return;
  const glm::dmat3 linear(toWorld);
  const double size = glm::length(linear[0]) * glm::length(linear[1]) * glm::length(linear[2]);
  if (!(std::abs(glm::determinant(linear)) > 1e-12 * size)) {
    context.warn(field + " is flattened by its transform (scale 0) and left out");
    return;
  }
  for (const uint32_t part : context.meshes[mesh]) {
    if (scene.instances.size() == kMaxInstances)
      context.fail(field, "is one instance more than the " + std::to_string(kMaxInstances) +
                              " that are read");
    const uint32_t key = uint32_t(scene.instances.size());
    scene.instances.push_back({name, variants.get(part, toWorld), toWorld, key});
  }
}

}  // namespace

void readNodes(GltfContext& context) {
  Variants variants(context);
  struct Visit {
    int node;
    glm::dmat4 parent;
  };
  // An own stack: files may nest nodes deeper than the machine's.
  std::vector<Visit> stack;
  const std::vector<int> roots = rootNodes(context);
  for (auto root = roots.rbegin(); root != roots.rend(); ++root)
    stack.push_back({*root, glm::dmat4(1)});
  while (!stack.empty()) {
    const auto [index, parent] = stack.back();
    stack.pop_back();
    const tinygltf::Node& node = context.model.nodes[size_t(index)];
    const std::string field = fieldAt("nodes", size_t(index));
    const glm::dmat4 toWorld = parent * localTransform(context, field, node);
    if (!finite(toWorld)) context.fail(field, "its transform overflows, expected finite numbers");
    const std::string name = node.name.empty() ? "node" + std::to_string(index) : node.name;
    if (node.mesh >= 0) addInstances(context, field, name, size_t(node.mesh), toWorld, variants);
    if (node.camera >= 0) addCamera(context, field, node.camera, toWorld);
    const auto light = node.extensions.find("KHR_lights_punctual");
    if (light != node.extensions.end()) addLight(context, light->second, toWorld);
    const size_t media = context.scene.media.size();
    readMediumExtras(context, field, node.extras, toWorld);
    if (context.scene.media.size() > media) context.scene.media.back().name = name;
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      stack.push_back({*child, toWorld});
  }
  if (context.model.nodes.empty() && !context.scene.meshes.empty()) {
    context.warn("the file has no nodes; each mesh is shown once, at the origin");
    for (size_t m = 0; m < context.meshes.size(); ++m)
      addInstances(context, fieldAt("meshes", m), context.model.meshes[m].name, m, glm::dmat4(1),
                   variants);
  }
  variants.arrange();
  closeFarPlanes(context.scene);
}

}  // namespace sb
