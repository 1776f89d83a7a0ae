// Convex outlines in the plane: whether two of them overlap.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace sb {

/// Convex hull, counter-clockwise (monotone chain, Andrew 1979). Fewer than three points when the
/// input has no area.
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points);

/// Whether the interiors of two convex outlines share a point (separating axes); outlines that only
/// touch, up to `margin`, do not. Outlines without area overlap nothing.
bool overlap(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b, double margin = 0);

}  // namespace sb
