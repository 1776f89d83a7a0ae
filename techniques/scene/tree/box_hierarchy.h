// A binary hierarchy of boxes over objects, split where their middles lie farthest apart. Boxes are
// refitted to objects that move; when they have grown too much, the hierarchy is made anew
// (Lauterbach et al. 2006: refitting until the boxes' surfaces have grown by a share).
#pragma once

#include "techniques/scene/tree/scene_tree.h"

namespace sb {

class BoxHierarchy final : public SceneTree {
 public:
  explicit BoxHierarchy(std::span<const Box> boxes);
  void place(uint32_t object, const Box& box) override;
  void remove(uint32_t object) override { place(object, Box()); }
  uint64_t query(const ConvexRegion& region, std::vector<uint32_t>& found) const override;

  /// How often it was made.
  uint32_t builds() const { return m_builds; }

 private:
  struct Node {
    Box box;
    uint32_t parent = kNone;
    /// Nodes, or of a leaf kNone and its object.
    uint32_t left = kNone, right = kNone;
  };
  void build();
  uint32_t build(std::span<uint32_t> objects, uint32_t parent);
  uint64_t query(uint32_t node, Lies lies, const ConvexRegion& region,
                 std::vector<uint32_t>& found) const;

  std::vector<Box> m_boxes;  ///< of objects
  std::vector<Node> m_nodes;
  std::vector<uint32_t> m_leaf;        ///< of objects
  double m_builtArea = 0, m_area = 0;  ///< of all nodes that are no leaves
  uint32_t m_builds = 0;
};

}  // namespace sb
