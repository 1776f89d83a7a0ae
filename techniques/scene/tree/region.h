// Convex regions that boxes are held against: a sphere, what half spaces have in common, or both.
#pragma once

#include <optional>
#include <vector>

#include "techniques/scene/box.h"

namespace sb {

/// Share of its distance by which the raster's floats (2^-24 of it) may move what is computed in
/// double: what touches within it is kept.
inline constexpr double kRasterSlack = 1e-6;

/// dot(normal, p - the region's origin) + offset >= 0 within.
struct HalfSpace {
  glm::dvec3 normal = glm::dvec3(0);  ///< unit
  double offset = 0;
};

struct Sphere {
  glm::dvec3 center = glm::dvec3(0);
  double radius = 0;
};

/// How a box lies to a region.
enum class Lies : uint8_t { Outside, Across, Inside };

/// Everything, until it is bounded.
struct ConvexRegion {
  glm::dvec3 origin = glm::dvec3(0);  ///< of the half spaces
  std::vector<HalfSpace> halfSpaces = {};
  std::optional<Sphere> sphere = {};

  /// Outside only where nothing of the box is within, Inside only where all of it is; what touches,
  /// up to what the raster's floats can move it, is Across.
  Lies lies(const Box& box) const;
};

/// What a camera sees. Relative to the eye, wherever it is.
std::vector<HalfSpace> frustumHalfSpaces(const Camera& camera, double aspect);

}  // namespace sb
