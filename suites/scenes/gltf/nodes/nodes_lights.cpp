// Lights and cameras with their place in the world.
#include <cmath>
#include <optional>

#include "suites/scenes/gltf/nodes/roots.h"
#include "techniques/scene/box.h"
#include "techniques/scene/light_area.h"

namespace sb {
namespace {

// Without its scale, which glTF tells viewers to ignore. Nothing if the scale is 0.
std::optional<glm::dmat4> rigid(const glm::dmat4& m) {
  const glm::dvec3 z = glm::normalize(glm::dvec3(m[2]));
  const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(m[1]), z));
  const glm::dmat4 frame(glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0), m[3]);
  if (!finite(frame)) return std::nullopt;
  return frame;
}

}  // namespace

void addLight(GltfContext& context, const std::string& node, const tinygltf::Value& reference,
              const glm::dmat4& toWorld) {
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
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(light.color[i] * light.intensity))
      context.fail(field + ".intensity", "times its colour is more than a 32-bit float can hold");
  light.range = source.range;
  light.position = glm::dvec3(toWorld[3]);
  if (light.type != LightType::Point) {
    const glm::dvec3 direction = glm::dmat3(toWorld) * glm::dvec3(0, 0, -1);
    if (!(glm::length(direction) > 0)) {
      // Tools hide what hangs on a node by scaling it to nothing.
      context.warn(node + " has scale 0: its light '" + light.name +
                   "' has no direction and is left out");
      return;
    }
    light.direction = glm::normalize(direction);
  }
  if (light.type == LightType::Spot) {
    light.innerCone = source.spot.innerConeAngle;
    light.outerCone = source.spot.outerConeAngle;
    if (!(light.innerCone < light.outerCone))
      context.fail(field + ".spot.innerConeAngle", "is " + shown(light.innerCone) +
                                                       ", expected less than outerConeAngle (" +
                                                       shown(light.outerCone) + ")");
  }
  // A sphere is the same under any node; what has axes needs a frame.
  const std::optional<glm::dmat4> frame = rigid(toWorld);
  readLightExtras(context, field, source.extras, glm::dmat3(frame.value_or(glm::dmat4(1))), light);
  if (!frame && light.shape != LightShape::Point && !isSphere(light)) {
    context.warn(node + " has scale 0: its light '" + light.name + "' has no axes and is left out");
    return;
  }
  context.scene.lights.push_back(light);
}

void addCamera(GltfContext& context, const std::string& node, int index,
               const glm::dmat4& toWorld) {
  const std::string field = fieldAt("cameras", size_t(index));
  const tinygltf::Camera& source = context.model.cameras[size_t(index)];
  Camera camera;
  camera.name = source.name.empty() ? "camera" + std::to_string(index) : source.name;
  const std::optional<glm::dmat4> frame = rigid(toWorld);
  if (!frame) {
    context.warn(node + " has scale 0: its camera '" + camera.name + "' is left out");
    return;
  }
  camera.toWorld = *frame;
  if (source.type == "perspective") {
    camera.fovY = source.perspective.yfov;
    if (camera.fovY >= 3.14159265358979)
      context.fail(field + ".perspective.yfov",
                   "is " + shown(camera.fovY) + ", expected less than pi");
    if (!(std::tan(0.5 * camera.fovY) > 1e-6))
      context.fail(field + ".perspective.yfov",
                   "is " + shown(camera.fovY) + ", expected an angle that sees something");
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
  const Box box = sceneBox(scene);
  for (Camera& camera : scene.cameras) {
    if (camera.farPlane > 0) continue;
    camera.farPlane = 10 * camera.nearPlane;
    if (!box.empty())
      camera.farPlane = std::max(camera.farPlane,
                                 1.01 * (glm::length(box.center() - camera.eye()) + box.radius()));
  }
}

}  // namespace sb
