#include "techniques/scene/geometry/hull2.h"

#include <algorithm>

namespace sb {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Whether an edge of `a` has all of `b` on its outer side.
bool separates(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b, double margin) {
  for (size_t i = 0; i < a.size(); ++i) {
    const glm::dvec2 from = a[i], edge = a[(i + 1) % a.size()] - from;
    const double least = margin * glm::length(edge);
    if (std::ranges::all_of(b, [&](const glm::dvec2& p) { return cross(edge, p - from) <= least; }))
      return true;
  }
  return false;
}

}  // namespace

std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points) {
  const auto less = [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  std::ranges::sort(points, less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<glm::dvec2> hull;
  const auto chain = [&](auto begin, auto end) {
    const size_t start = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= start + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // the other chain begins with it
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

bool overlap(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b, double margin) {
  if (a.size() < 3 || b.size() < 3) return false;
  return !separates(a, b, margin) && !separates(b, a, margin);
}

}  // namespace sb
