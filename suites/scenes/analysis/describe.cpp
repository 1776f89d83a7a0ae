#include "suites/scenes/analysis/describe.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "suites/scenes/analysis/penumbra_bound.h"
#include "techniques/scene/light_area.h"
#include "techniques/scene/optics.h"
#include "techniques/scene/placed_scene.h"

namespace sb {
namespace {

using nlohmann::json;

const char* className(MaterialClass c) {
  constexpr const char* kNames[] = {"opaque", "perforated", "translucent"};
  return kNames[size_t(c)];
}
const char* typeName(LightType t) {
  constexpr const char* kNames[] = {"directional", "point", "spot"};
  return kNames[size_t(t)];
}
const char* shapeName(LightShape s) {
  constexpr const char* kNames[] = {"point", "ellipsoid", "rectangle", "disc"};
  return kNames[size_t(s)];
}

std::vector<double> triple(glm::dvec3 v) { return {v.x, v.y, v.z}; }
std::vector<double> triple(glm::vec3 v) { return {v.x, v.y, v.z}; }

json materialsJson(const Scene& scene) {
  std::array<int, 3> counts{};
  json list = json::array();
  for (const Material& material : scene.materials) {
    const MaterialTraits traits = materialTraits(scene, material);
    ++counts[size_t(traits.lightClass)];
    list.push_back({{"name", material.name},
                    {"class", className(traits.lightClass)},
                    {"textured", traits.textured},
                    {"coloured", traits.coloured},
                    {"seen_through", traits.cameraTranslucent}});
  }
  return {
      {"opaque", counts[0]}, {"perforated", counts[1]}, {"translucent", counts[2]}, {"list", list}};
}

json lightJson(const Light& light, const LightEffects& effects) {
  json j = {{"name", light.name},
            {"type", typeName(light.type)},
            {"color", triple(light.color)},
            {"intensity", light.intensity},
            {"touches_view", effects.touchesView},
            {"opaque_casters", effects.opaqueCasters.size()},
            {"perforated_casters", effects.perforatedCasters.size()},
            {"translucent_casters", effects.translucentCasters.size()},
            {"penumbra", effects.penumbra}};
  if (light.type != LightType::Point) j["direction"] = triple(light.direction);
  if (light.type == LightType::Directional) {
    j["angular_radius"] = light.angularRadius;
    return j;
  }
  if (isAreaLight(light)) {
    j["shape"] = shapeName(light.shape);
    j["half_axes"] = json::array();
    for (int i = 0; i < 3; ++i) j["half_axes"].push_back(triple(light.halfAxes[i]));
  }
  j["position"] = triple(light.position);
  j["range"] = light.range > 0 ? json(light.range) : json();
  return j;
}

json cameraJson(const Camera& camera) {
  json j = {{"name", camera.name},
            {"eye", triple(camera.eye())},
            {"near", camera.nearPlane},
            {"far", camera.farPlane}};
  if (camera.orthographic)
    j["half_height"] = camera.halfHeight;
  else
    j["fov_y"] = camera.fovY;
  return j;
}

/// Steps of the loop, and what moves along it; null: nothing.
json motionJson(const Scene& scene) {
  if (scene.path.empty()) return {};
  const Moving moving(scene);
  const auto lights = std::ranges::count_if(scene.lights, [](auto& l) { return l.pose != kNone; });
  return {{"steps", scene.path.size()},
          {"camera", moving.camera},
          {"lights", lights},
          {"instances", moving.instances.size()}};
}

std::string motionLine(const json& motion) {
  return fmt::format("  moves in {} steps: {} instances, {} lights{}\n",
                     motion["steps"].get<size_t>(), motion["instances"].get<size_t>(),
                     motion["lights"].get<size_t>(),
                     motion["camera"].get<bool>() ? ", the camera" : "");
}

/// ", ellipsoid of half axes 1, 1, 1"
std::string extentText(const Light& light) {
  if (!isAreaLight(light)) return "";
  if (light.type == LightType::Directional)
    return fmt::format(", angular radius {:.4g}", light.angularRadius);
  std::string text = fmt::format(", {} of half axes", shapeName(light.shape));
  const int axes = light.shape == LightShape::Ellipsoid ? 3 : 2;
  for (int i = 0; i < axes; ++i)
    text += fmt::format("{} {:.4g}", i == 0 ? "" : ",", glm::length(light.halfAxes[i]));
  return text;
}

std::string lightLine(const json& light, const std::string& extent) {
  if (!light["touches_view"].get<bool>())
    return fmt::format("  {} ({}): does not touch the view\n", light["name"].get<std::string>(),
                       light["type"].get<std::string>());
  const double penumbra = light["penumbra"];
  const std::string soft = penumbra > 0 ? ", " + penumbraBoundText(penumbra) : "";
  return fmt::format("  {} ({}{}): {} opaque, {} perforated, {} translucent casters{}\n",
                     light["name"].get<std::string>(), light["type"].get<std::string>(), extent,
                     light["opaque_casters"].get<size_t>(),
                     light["perforated_casters"].get<size_t>(),
                     light["translucent_casters"].get<size_t>(), soft);
}

}  // namespace

json describeJson(const Scene& scene, const Effects& effects) {
  json j = {{"name", scene.name},
            {"meshes", scene.meshes.size()},
            {"instances", scene.instances.size()},
            {"materials", materialsJson(scene)},
            {"visible_instances", effects.visibleOpaque.size() + effects.visibleTranslucent.size()},
            {"media", scene.media.size()},
            {"motion", motionJson(scene)},
            {"warnings", scene.warnings}};
  size_t own = 0, instanced = 0;
  for (const Mesh& mesh : scene.meshes) own += mesh.triangleCount();
  for (const Instance& i : scene.instances) instanced += scene.meshes.at(i.mesh).triangleCount();
  j["triangles"] = own;
  j["instanced_triangles"] = instanced;
  j["lights"] = j["cameras"] = j["images"] = j["effects"] = json::array();
  for (size_t i = 0; i < scene.lights.size(); ++i)
    j["lights"].push_back(lightJson(scene.lights[i], effects.lights.at(i)));
  for (const Camera& camera : scene.cameras) j["cameras"].push_back(cameraJson(camera));
  for (const Image& image : scene.images)
    j["images"].push_back({{"name", image.name}, {"width", image.width}, {"height", image.height}});
  for (const auto& [effect, why] : effects.reason)
    j["effects"].push_back(
        {{"effect", effectName(effect)}, {"present", effects.present.has(effect)}, {"why", why}});
  return j;
}

std::string describeText(const Scene& scene, const Effects& effects) {
  const json j = describeJson(scene, effects);
  const json& materials = j["materials"];
  std::string text = fmt::format(
      "{}\n  {} meshes, {} instances ({} visible), {} triangles ({} with instances)\n"
      "  {} materials: {} opaque, {} perforated, {} translucent\n"
      "  {} images, {} lights, {} cameras, {} media\n",
      scene.name, scene.meshes.size(), scene.instances.size(), j["visible_instances"].get<size_t>(),
      j["triangles"].get<size_t>(), j["instanced_triangles"].get<size_t>(), scene.materials.size(),
      materials["opaque"].get<int>(), materials["perforated"].get<int>(),
      materials["translucent"].get<int>(), scene.images.size(), scene.lights.size(),
      scene.cameras.size(), scene.media.size());
  if (!scene.path.empty()) text += motionLine(j["motion"]);
  text += "\nCameras (the first is shown)\n";
  for (size_t i = 0; i < scene.cameras.size(); ++i)
    text += fmt::format("  {} {}{}\n", i, scene.cameras[i].name,
                        scene.cameras[i].orthographic ? " (orthographic)" : "");
  text += "\nLights\n";
  for (size_t i = 0; i < scene.lights.size(); ++i)
    text += lightLine(j["lights"][i], extentText(scene.lights[i]));
  for (const bool present : {true, false}) {
    text += present ? "\nCalls for\n" : "\nDoes not call for\n";
    for (const json& effect : j["effects"])
      if (effect["present"] == present)
        text += fmt::format("  {:<23} {}\n", effect["effect"].get<std::string>(),
                            effect["why"].get<std::string>());
  }
  if (!scene.warnings.empty()) text += "\nWarnings\n";
  for (const std::string& warning : scene.warnings) text += "  " + warning + "\n";
  return text;
}

}  // namespace sb
