// A tree of boxes over triangles as rays walk it: eight children a node, four triangles a leaf,
// laid out for vector instructions. Built by Embree (surface area heuristic). Boxes are in float,
// rounded outward; triangles in double, tested as suites/truth/rays/watertight.h tests them.
#pragma once

#include <memory>
#include <vector>

#include "suites/truth/rays/box_walk.h"
#include "suites/truth/rays/triangles.h"

namespace sb {

class BoxTree {
 public:
  /// `extent`: no coordinate, of rays neither, is larger. `clear`: TriangleLeaf, of each triangle.
  /// Throws std::runtime_error when Embree refuses.
  BoxTree(const std::vector<TruthTriangle>& triangles, double extent,
          const std::vector<float>& clear);
  BoxTreeView view() const { return {m_nodes.data(), m_leaves.data(), m_root, m_margin}; }
  bool empty() const { return m_leaves.empty(); }
  uint64_t bytes() const {
    return m_nodes.size() * sizeof(BoxNode) + m_leaves.size() * sizeof(TriangleLeaf);
  }

 private:
  std::vector<BoxNode> m_nodes;
  std::vector<TriangleLeaf> m_leaves;
  uint32_t m_root = 0;
  double m_margin;
};

}  // namespace sb
