// Where depth-pass counting goes wrong: between a light and the camera's near rectangle (spec 07).
// A shadow volume holds a point of the rectangle only if its caster meets that pyramid.
#pragma once

#include <array>

#include "techniques/scene/box.h"

namespace sb {

/// Corners of the near rectangle relative to the eye, one beside the next.
std::array<glm::dvec3, 4> nearRectangle(const Camera& camera, double aspect);

/// `light`: relative to the eye, w 1; or the way to it, w 0 (the pyramid is a prism). False where
/// no caster within the sphere can darken the rectangle. A light about in the rectangle's plane:
/// true.
bool meetsNearPyramid(const std::array<glm::dvec3, 4>& rectangle, const glm::dvec4& light,
                      const glm::dvec3& center, double radius);

}  // namespace sb
