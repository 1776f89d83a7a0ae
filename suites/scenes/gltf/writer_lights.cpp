#include "suites/scenes/edit/framing.h"
#include "suites/scenes/gltf/writer.h"

namespace sb {

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
    if (light.radius > 0) j["extras"]["shadowbench"]["radius"] = light.radius;
    json& lights = m_gltf["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back(std::move(j));
    // Lights shine along -z of their node.
    glm::dmat4 frame = lookFrom(glm::dvec3(0), light.direction);
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
