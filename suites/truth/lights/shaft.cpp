#include "suites/truth/lights/shaft.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "suites/truth/rays/watertight.h"

namespace sb {

using glm::dvec3;

namespace {

constexpr uint32_t kLeaf = 4;
/// Sines below this are 0: a plane through the apex that the light is seen edge-on in separates
/// nothing for certain.
constexpr double kEdgeOn = 1e-9;

}  // namespace

Shaft::Shaft(const dvec3& apex, const LightPatch& patch, double slack)
    : m_apex(apex), m_infinite(patch.infinite), m_slack(slack) {
  m_count = patch.hull(m_corners);
  for (size_t i = 0; i < m_count; ++i)
    addPlane(glm::cross(m_corners[i], m_corners[(i + 1) % m_count]), patch.centre, dvec3(0));
  if (!m_infinite) addPlane(glm::cross(patch.u, patch.v), dvec3(0), patch.centre);
}

void Shaft::addPlane(const dvec3& normal, const dvec3& within, const dvec3& on) {
  const double length = glm::length(normal);
  const dvec3 unit = normal / length;
  const double side = glm::dot(unit, within - on);
  if (!(std::abs(side) > kEdgeOn * glm::length(within - on))) return;
  const dvec3 outward = side > 0 ? -unit : unit;
  m_planes[m_planeCount++] = {outward, glm::dot(outward, on)};
}

bool Shaft::mayHold(const dvec3& low, const dvec3& high) const {
  const dvec3 centre = 0.5 * (low + high) - m_apex, half = 0.5 * (high - low);
  for (size_t i = 0; i < m_planeCount; ++i) {
    const Plane& p = m_planes[i];
    if (glm::dot(p.normal, centre) - glm::dot(glm::abs(p.normal), half) > p.offset + m_slack)
      return false;
  }
  return true;
}

bool Shaft::mayHold(const TruthTriangle& triangle) const {
  const dvec3 q[3] = {triangle.corners[0] - m_apex, triangle.corners[1] - m_apex,
                      triangle.corners[2] - m_apex};
  for (size_t i = 0; i < m_planeCount; ++i) {
    const Plane& p = m_planes[i];
    const double least =
        std::min({glm::dot(p.normal, q[0]), glm::dot(p.normal, q[1]), glm::dot(p.normal, q[2])});
    if (least > p.offset + m_slack) return false;
  }
  // All of the shaft on one side of the triangle's plane?
  const dvec3 normal = glm::cross(q[1] - q[0], q[2] - q[0]);
  const double slack = m_slack * glm::length(normal);
  const double apex = -glm::dot(normal, q[0]);
  bool above = apex > slack, below = apex < -slack;
  for (const dvec3& c : corners()) {
    const double side = m_infinite ? glm::dot(normal, c) : glm::dot(normal, c - q[0]);
    const double least = m_infinite ? kEdgeOn * glm::length(normal) : slack;
    above &= side > least;
    below &= side < -least;
  }
  return !above && !below;
}

bool Shaft::isCoveredBy(const TruthTriangle& triangle) const {
  return std::ranges::all_of(corners(), [&](const dvec3& corner) {
    const auto hit = intersect(ShearedRay<double>(m_apex, corner), triangle.corners);
    return hit && hit->t > 0 && (m_infinite || hit->t < 1);
  });
}

ShaftTree::ShaftTree(const std::vector<TruthTriangle>& triangles)
    : m_triangles(triangles), m_order(triangles.size()) {
  std::iota(m_order.begin(), m_order.end(), 0u);
  std::vector<dvec3> centres;
  for (const TruthTriangle& t : triangles)
    centres.push_back(t.corners[0] + t.corners[1] + t.corners[2]);
  if (!triangles.empty()) build(0, uint32_t(triangles.size()), centres);
}

uint32_t ShaftTree::build(uint32_t first, uint32_t count, const std::vector<dvec3>& centres) {
  Node node{dvec3(HUGE_VAL), dvec3(-HUGE_VAL), first, count};
  dvec3 low(HUGE_VAL), high(-HUGE_VAL);  // of centres
  const auto begin = m_order.begin() + first, end = begin + count;
  for (auto t = begin; t != end; ++t) {
    for (const dvec3& corner : m_triangles[*t].corners) {
      node.low = glm::min(node.low, corner);
      node.high = glm::max(node.high, corner);
    }
    low = glm::min(low, centres[*t]);
    high = glm::max(high, centres[*t]);
  }
  const auto index = uint32_t(m_nodes.size());
  m_nodes.push_back(node);
  if (count <= kLeaf) return index;
  const dvec3 size = high - low;
  const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  std::nth_element(begin, begin + count / 2, end,
                   [&](uint32_t a, uint32_t b) { return centres[a][axis] < centres[b][axis]; });
  build(first, count / 2, centres);
  const uint32_t second = build(first + count / 2, count - count / 2, centres);
  m_nodes[index].count = 0;
  m_nodes[index].first = second;
  return index;
}

void ShaftTree::gather(const Shaft& shaft, std::vector<uint32_t>& out) const {
  out.clear();
  if (m_nodes.empty()) return;
  std::array<uint32_t, 64> stack{};  // halving 2^32 triangles goes 32 deep
  size_t depth = 1;
  while (depth > 0) {
    const uint32_t index = stack[--depth];
    const Node& node = m_nodes[index];
    if (!shaft.mayHold(node.low, node.high)) continue;
    if (node.count == 0) {
      stack[depth++] = node.first;
      stack[depth++] = index + 1;
      continue;
    }
    for (uint32_t i = node.first; i < node.first + node.count; ++i)
      if (shaft.mayHold(m_triangles[m_order[i]])) out.push_back(m_order[i]);
  }
  std::ranges::sort(out);
}

}  // namespace sb
