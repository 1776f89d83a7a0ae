#include "suites/scenes/edit/framing.h"
#include "suites/scenes/gltf/write/writer.h"
#include "techniques/scene/light_area.h"

namespace sb {
namespace {

nlohmann::json extentJson(const Light& light) {
  if (light.type == LightType::Directional) return {{"radius", light.angularRadius}};
  if (isSphere(light)) return {{"radius", light.halfAxes[0][0]}};
  nlohmann::json lengths = nlohmann::json::array();
  for (int i = 0; i < (light.shape == LightShape::Ellipsoid ? 3 : 2); ++i)
    lengths.push_back(glm::length(light.halfAxes[i]));
  const char* shape = light.shape == LightShape::Ellipsoid   ? "ellipsoid"
                      : light.shape == LightShape::Rectangle ? "rectangle"
                                                             : "disc";
  return {{"shape", shape}, {"half_axes", lengths}};
}

/// Lights shine along -z of their node; half axes lie along its axes.
glm::dmat4 frameOf(const Light& light) {
  const bool axes = light.type != LightType::Directional && light.shape != LightShape::Point;
  if (!axes || isSphere(light)) return lookFrom(glm::dvec3(0), light.direction);
  const glm::dvec3 x = glm::normalize(light.halfAxes[0]), y = glm::normalize(light.halfAxes[1]);
  return glm::dmat4(glm::dmat3(x, y, glm::cross(x, y)));
}

}  // namespace

void GltfWriter::addLights() {
  constexpr const char* kTypes[] = {"directional", "point", "spot"};
  for (const Light& light : m_scene.lights) {
    use("KHR_lights_punctual");
    json j = {{"name", light.name},
              {"type", kTypes[size_t(light.type)]},
              {"color", vectorJson(light.color)},
              {"intensity", light.intensity}};
    if (light.range > 0 && light.type != LightType::Directional) j["range"] = light.range;
    if (light.type == LightType::Spot)
      j["spot"] = {{"innerConeAngle", light.innerCone}, {"outerConeAngle", light.outerCone}};
    if (isAreaLight(light)) j["extras"]["shadowbench"] = extentJson(light);
    json& lights = m_gltf["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back(std::move(j));
    glm::dmat4 frame = frameOf(light);
    frame[3] = glm::dvec4(light.position, 1);
    addNode({{"name", light.name},
             {"matrix", matrixJson(frame)},
             {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
  }
}

void GltfWriter::addCameras() {
  for (const Camera& camera : m_scene.cameras) {
    json j = {{"name", camera.name}};
    if (camera.orthographic) {
      j["type"] = "orthographic";
      j["orthographic"] = {{"xmag", camera.halfHeight},
                           {"ymag", camera.halfHeight},
                           {"znear", camera.nearPlane},
                           {"zfar", camera.farPlane}};
    } else {
      j["type"] = "perspective";
      j["perspective"] = {
          {"yfov", camera.fovY}, {"znear", camera.nearPlane}, {"zfar", camera.farPlane}};
    }
    m_gltf["cameras"].push_back(std::move(j));
    addNode({{"name", camera.name},
             {"matrix", matrixJson(camera.toWorld)},
             {"camera", m_gltf["cameras"].size() - 1}});
  }
}

}  // namespace sb
