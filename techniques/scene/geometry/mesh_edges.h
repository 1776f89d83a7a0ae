// Edges of a mesh as its triangles have them, corners at one position being one vertex.
#pragma once

#include <vector>

#include "techniques/scene/scene.h"

namespace sb {

/// The first vertex at the position of each; -0 is 0.
std::vector<uint32_t> weldedVertices(const std::vector<glm::vec3>& positions);

/// An edge as one of its triangles has it.
struct EdgeSide {
  uint32_t low = 0, high = 0;  ///< welded vertices, low < high: the edge's own direction
  uint32_t triangle = 0;
  uint32_t opposite = 0;  ///< the triangle's third corner, welded
  bool forward = false;   ///< the triangle goes from low to high
};

/// Sides of all edges of positive length, those of one edge next to one another, in the order of
/// their triangles.
std::vector<EdgeSide> edgeSides(const Mesh& mesh);

}  // namespace sb
