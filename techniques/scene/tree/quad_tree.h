// A quadtree over the ground (x and z) whose squares are made once, empty, and never change (the
// thesis of the third source document, section 5.3). An object is kept in the smallest square that
// holds it, so that objects of any size fit; it leaves its square in constant time, and only when
// it no longer fits there.
#pragma once

#include "techniques/scene/tree/scene_tree.h"

namespace sb {

class QuadTree final : public SceneTree {
 public:
  explicit QuadTree(std::span<const Box> boxes);
  void place(uint32_t object, const Box& box) override;
  void remove(uint32_t object) override;
  uint64_t query(const ConvexRegion& region, std::vector<uint32_t>& found) const override;

  /// Squares along a side of the finest level, a power of two.
  uint32_t side() const { return 1u << m_levels; }
  /// How often an object was put into another square than before.
  uint64_t reinsertions() const { return m_reinsertions; }

 private:
  struct Square {
    Box box;                 ///< as tall as all objects were at first
    uint32_t first = kNone;  ///< object
  };
  struct Object {
    Box box;
    uint32_t square = kNone;  ///< kNone: in none
    uint32_t before = kNone, after = kNone;
  };
  /// The square below that holds the box, or kNone.
  uint32_t below(uint32_t square, const Box& box) const;
  /// `lies`: how the square itself does.
  uint64_t query(uint32_t square, Lies lies, const ConvexRegion& region,
                 std::vector<uint32_t>& found) const;

  uint32_t m_levels = 0;  ///< below the root
  /// Level by level; children of i are 4 i + 1 to 4 i + 4. The first holds what no other does,
  /// wherever that is.
  std::vector<Square> m_squares;
  std::vector<Object> m_objects;
  uint64_t m_reinsertions = 0;
};

}  // namespace sb
