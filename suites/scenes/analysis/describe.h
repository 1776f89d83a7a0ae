// What is in a scene and what it calls for, for people and for programs (`bench scene`).
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "techniques/plan/effects.h"
#include "techniques/scene/scene.h"

namespace sb {

/// Several lines, each effect with the reason why it is called for or not.
std::string describeText(const Scene& scene, const Effects& effects);
/// {"name", "meshes", "instances", "triangles", "instanced_triangles", "materials": {"opaque",
/// "perforated", "translucent", "list": [...]}, "lights", "cameras", "media", "images", "effects":
/// [{"effect", "present", "why"}], "warnings"}
nlohmann::json describeJson(const Scene& scene, const Effects& effects);

}  // namespace sb
