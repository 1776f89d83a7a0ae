#include "techniques/scene/tree/box_hierarchy.h"

#include <algorithm>
#include <numeric>

namespace sb {
namespace {

/// Boxes may grow by this factor before the hierarchy is made anew.
constexpr double kMostGrowth = 2;

double areaOf(const Box& box) {
  if (box.empty()) return 0;
  const glm::dvec3 d = box.high - box.low;
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

Box around(const Box& a, const Box& b) {
  Box both = a;
  both.add(b);
  return both;
}

}  // namespace

BoxHierarchy::BoxHierarchy(std::span<const Box> boxes)
    : m_boxes(boxes.begin(), boxes.end()), m_leaf(boxes.size()) {
  build();
}

void BoxHierarchy::build() {
  m_nodes.clear();
  m_area = 0;
  std::vector<uint32_t> objects(m_boxes.size());
  std::iota(objects.begin(), objects.end(), 0u);
  if (!objects.empty()) build(objects, kNone);
  m_builtArea = m_area;
  ++m_builds;
}

uint32_t BoxHierarchy::build(std::span<uint32_t> objects, uint32_t parent) {
  const uint32_t index = uint32_t(m_nodes.size());
  m_nodes.push_back({.box = {}, .parent = parent});
  if (objects.size() == 1) {
    m_nodes[index].right = objects[0];
    m_nodes[index].box = m_boxes[objects[0]];
    m_leaf[objects[0]] = index;
    return index;
  }
  // What is nowhere at the moment counts as at zero: it may come back anywhere.
  const auto middle = [&](uint32_t i) {
    return m_boxes[i].empty() ? glm::dvec3(0) : m_boxes[i].center();
  };
  Box middles;
  for (const uint32_t i : objects) middles.add(middle(i));
  const glm::dvec3 size = middles.high - middles.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const size_t half = objects.size() / 2;
  std::ranges::nth_element(objects, objects.begin() + std::ptrdiff_t(half), {},
                           [&](uint32_t i) { return std::pair(middle(i)[axis], i); });
  const uint32_t left = build(objects.first(half), index);
  const uint32_t right = build(objects.subspan(half), index);
  Node& node = m_nodes[index];
  node.left = left, node.right = right;
  node.box = around(m_nodes[left].box, m_nodes[right].box);
  m_area += areaOf(node.box);
  return index;
}

void BoxHierarchy::place(uint32_t object, const Box& box) {
  m_boxes[object] = box;
  m_nodes[m_leaf[object]].box = box;
  for (uint32_t i = m_nodes[m_leaf[object]].parent; i != kNone; i = m_nodes[i].parent) {
    Node& node = m_nodes[i];
    const Box fitted = around(m_nodes[node.left].box, m_nodes[node.right].box);
    if (fitted.low == node.box.low && fitted.high == node.box.high) break;
    m_area += areaOf(fitted) - areaOf(node.box);
    node.box = fitted;
  }
  if (m_area > kMostGrowth * m_builtArea) build();
}

uint64_t BoxHierarchy::query(const ConvexRegion& region, std::vector<uint32_t>& found) const {
  return m_nodes.empty() ? 0 : query(0, Lies::Across, region, found);
}

uint64_t BoxHierarchy::query(uint32_t index, Lies lies, const ConvexRegion& region,
                             std::vector<uint32_t>& found) const {
  const Node& node = m_nodes[index];
  uint64_t tests = 0;
  if (lies == Lies::Across) ++tests, lies = region.lies(node.box);
  if (lies == Lies::Outside || node.box.empty()) return tests;
  if (node.left == kNone) {
    found.push_back(node.right);
    return tests;
  }
  return tests + query(node.left, lies, region, found) + query(node.right, lies, region, found);
}

}  // namespace sb
