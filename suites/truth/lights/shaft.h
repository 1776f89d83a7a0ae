// Which triangles may stand between a receiver and a light with an extent: a tree of boxes, asked
// with the hull of both (after Haines and Wallace, "Shaft Culling for Efficient Ray-Cast
// Radiosity", 1991). Conservative: what is left out meets no ray between the two.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "suites/truth/rays/triangles.h"
#include "techniques/scene/light_area.h"

namespace sb {

/// The hull of a receiver and of what it sees of a light.
class Shaft {
 public:
  /// `slack`: what coordinates may be off by, world units.
  Shaft(const glm::dvec3& apex, const LightPatch& patch, double slack);

  /// False only if nothing of the box (of the triangle) lies within.
  bool mayHold(const glm::dvec3& low, const glm::dvec3& high) const;
  bool mayHold(const TruthTriangle& triangle) const;
  /// Does the triangle hide all of the light from the receiver?
  bool isCoveredBy(const TruthTriangle& triangle) const;
  /// Corners around the light, relative to the apex.
  std::span<const glm::dvec3> corners() const { return {m_corners.data(), m_count}; }

 private:
  struct Plane {
    glm::dvec3 normal;  ///< unit, outward
    double offset;      ///< of the plane along it, from the apex
  };
  void addPlane(const glm::dvec3& normal, const glm::dvec3& within, const glm::dvec3& on);

  const glm::dvec3 m_apex;
  const bool m_infinite;
  const double m_slack;
  std::array<glm::dvec3, 8> m_corners{};
  size_t m_count = 0;
  std::array<Plane, 9> m_planes{};
  size_t m_planeCount = 0;
};

class ShaftTree {
 public:
  /// `triangles` must outlive the tree.
  explicit ShaftTree(const std::vector<TruthTriangle>& triangles);
  /// Triangles that may lie within, in the order of their numbers.
  void gather(const Shaft& shaft, std::vector<uint32_t>& out) const;
  uint64_t bytes() const {
    return m_nodes.size() * sizeof(Node) + m_order.size() * sizeof(uint32_t);
  }

 private:
  struct Node {
    glm::dvec3 low, high;
    uint32_t first = 0, count = 0;  ///< of a leaf; count 0: children at the next place and at first
  };
  uint32_t build(uint32_t first, uint32_t count, const std::vector<glm::dvec3>& centres);

  const std::vector<TruthTriangle>& m_triangles;
  std::vector<uint32_t> m_order;
  std::vector<Node> m_nodes;
};

}  // namespace sb
