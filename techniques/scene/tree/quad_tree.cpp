#include "techniques/scene/tree/quad_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sb {
namespace {

double widthOf(const Box& box) { return std::max(box.high.x - box.low.x, box.high.z - box.low.z); }

bool holds(const Box& outer, const Box& inner) {
  return glm::all(glm::lessThanEqual(outer.low, inner.low)) &&
         glm::all(glm::lessThanEqual(inner.high, outer.high));
}

/// Squares that are smaller than most objects hold few, and squares that outnumber them none.
uint32_t levelsFor(std::span<const Box> boxes, double side) {
  std::vector<double> widths;
  for (const Box& box : boxes)
    if (!box.empty()) widths.push_back(widthOf(box));
  if (widths.empty() || !(side > 0)) return 0;
  const auto middle = widths.begin() + std::ptrdiff_t(widths.size() / 2);
  std::ranges::nth_element(widths, middle);
  const double bySize = *middle > 0 ? std::log2(side / *middle) : 16;
  const double byCount = std::ceil(0.5 * std::log2(double(widths.size())));
  return uint32_t(std::clamp(std::min(bySize, byCount), 0.0, 8.0));
}

}  // namespace

QuadTree::QuadTree(std::span<const Box> boxes) {
  Box all;
  for (const Box& box : boxes) all.add(box);
  const double side = all.empty() ? 0 : widthOf(all);
  m_levels = levelsFor(boxes, side);
  m_squares.resize(((size_t(1) << (2 * (m_levels + 1))) - 1) / 3);
  m_squares[0].box = all;
  if (!all.empty())
    m_squares[0].box.high.x = all.low.x + side, m_squares[0].box.high.z = all.low.z + side;
  for (size_t i = 1; i < m_squares.size(); ++i) {
    const Box& outer = m_squares[(i - 1) / 4].box;
    const glm::dvec3 middle = outer.center();
    Box& box = m_squares[i].box = outer;
    ((i - 1) & 1 ? box.low.x : box.high.x) = middle.x;
    ((i - 1) & 2 ? box.low.z : box.high.z) = middle.z;
  }
  m_objects.resize(boxes.size());
  for (uint32_t i = 0; i < boxes.size(); ++i) place(i, boxes[i]);
  m_reinsertions = 0;
}

uint32_t QuadTree::below(uint32_t square, const Box& box) const {
  const size_t first = 4 * size_t(square) + 1;
  if (first >= m_squares.size()) return kNone;
  const glm::dvec3 middle = m_squares[square].box.center();
  const uint32_t child =
      uint32_t(first) + (box.low.x >= middle.x ? 1 : 0) + (box.low.z >= middle.z ? 2 : 0);
  return holds(m_squares[child].box, box) ? child : kNone;
}

void QuadTree::place(uint32_t object, const Box& box) {
  Object& o = m_objects[object];
  o.box = box;
  if (box.empty()) return remove(object);
  uint32_t square = 0;
  if (o.square != kNone) {
    const bool stays = o.square == 0 || holds(m_squares[o.square].box, box);
    if (stays && below(o.square, box) == kNone) return;
    if (stays) square = o.square;
    remove(object);
  }
  for (uint32_t child = below(square, box); child != kNone; child = below(square, box))
    square = child;
  ++m_reinsertions;
  o.square = square;
  o.after = std::exchange(m_squares[square].first, object);
  if (o.after != kNone) m_objects[o.after].before = object;
}

void QuadTree::remove(uint32_t object) {
  Object& o = m_objects[object];
  if (o.square == kNone) return;
  (o.before == kNone ? m_squares[o.square].first : m_objects[o.before].after) = o.after;
  if (o.after != kNone) m_objects[o.after].before = o.before;
  o.square = o.before = o.after = kNone;
}

uint64_t QuadTree::query(const ConvexRegion& region, std::vector<uint32_t>& found) const {
  return query(0, Lies::Across, region, found);
}

uint64_t QuadTree::query(uint32_t square, Lies lies, const ConvexRegion& region,
                         std::vector<uint32_t>& found) const {
  uint64_t tests = 0;
  for (uint32_t i = m_squares[square].first; i != kNone; i = m_objects[i].after) {
    if (lies == Lies::Across) ++tests;
    if (lies == Lies::Inside || region.lies(m_objects[i].box) != Lies::Outside) found.push_back(i);
  }
  const size_t first = 4 * size_t(square) + 1;
  for (size_t child = first; child < std::min(first + 4, m_squares.size()); ++child) {
    Lies below = lies;
    if (lies == Lies::Across) ++tests, below = region.lies(m_squares[child].box);
    if (below != Lies::Outside) tests += query(uint32_t(child), below, region, found);
  }
  return tests;
}

}  // namespace sb
