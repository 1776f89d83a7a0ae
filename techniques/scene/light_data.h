// A light as shaders see it, and as the shading of the truth sees it.
#pragma once

#include "shaders/common/shared_types.h"
#include "techniques/scene/scene.h"

namespace sb {

/// `index`: into Scene::lights. Without shadow views.
gpu::LightData lightData(const Light& light, uint32_t index, const glm::dvec3& eye);

/// Rotation world -> light whose z axis points back at the light (it looks down -z): rows are the
/// axes of the light's map.
glm::dmat3 lightAxes(const glm::dvec3& direction);

/// Direction of face 0..5 of a point light: +x -x +y -y +z -z.
glm::dvec3 cubeFaceDirection(uint32_t face);
/// Face that looks at `d` (shaders/common/light_space.glsl, cubeFace).
uint32_t cubeFaceOf(const glm::dvec3& d);

}  // namespace sb
