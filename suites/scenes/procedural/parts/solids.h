// Closed solids, and what scenes after the third source document share: lamps of finite range,
// things that go round on the ground.
#pragma once

#include <string_view>

#include "suites/scenes/procedural/scenes.h"

namespace sb {

/// From -1 to 1 along each axis, normals outward; of a room, inward.
Mesh cubeMesh(std::string name, uint32_t material, bool inward = false);
/// Radius 1 about the y axis, from -1 to 1, with flat ends; `sides` is 3 at least.
Mesh columnMesh(std::string name, uint32_t material, uint32_t sides);

/// Scales by `half`, turns about y, moves to `middle`.
glm::dmat4 solidAt(const glm::dvec3& middle, const glm::dvec3& half, double turn = 0);

/// A warm lamp of a radius (0 casts hard shadows) whose light ends at `range`.
void addLamp(Scene& scene, const glm::dvec3& position, double radius, double range,
             float intensity);

/// A share of the instances whose names begin so, drawn without their order mattering, go round
/// circles on the ground with radii from 0.1 to `widest`.
void circleOnGround(Scene& scene, std::string_view prefix, double share, double widest,
                    uint64_t seed, uint32_t steps);

/// Their parameters.
SceneParam lampRadiusParam(double fallback);
SceneParam movingShareParam(std::string what);
SceneParam seedParam(std::string of);

}  // namespace sb
