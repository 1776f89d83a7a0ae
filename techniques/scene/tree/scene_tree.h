// Objects found by where they are, without looking at each. They move; a tree that was made once
// serves wherever they go.
#pragma once

#include <memory>
#include <span>

#include "techniques/scene/tree/region.h"

namespace sb {

enum class TreeKind : uint8_t {
  List,      ///< each object in turn
  QuadTree,  ///< fixed squares of the ground (quad_tree.h)
  Boxes,     ///< a hierarchy of boxes that follow what they hold (box_hierarchy.h)
};

class SceneTree {
 public:
  virtual ~SceneTree() = default;
  /// The object is in this box from now on; one that was removed is back.
  virtual void place(uint32_t object, const Box& box) = 0;
  virtual void remove(uint32_t object) = 0;
  /// Adds every object whose box is not outside, in no order, and perhaps others that are not
  /// outside by less than rounding. Gives how many boxes were held against the region.
  virtual uint64_t query(const ConvexRegion& region, std::vector<uint32_t>& found) const = 0;
};

/// Of objects 0, 1, ...: the tree is laid out for where they are at first.
std::unique_ptr<SceneTree> makeSceneTree(TreeKind kind, std::span<const Box> boxes);

}  // namespace sb
