#include "suites/truth/rays/bvh.h"

#include <algorithm>
#include <cmath>

#include "suites/truth/rays/ray_search.h"

namespace sb {
namespace {

double extentOf(const std::vector<TruthTriangle>& triangles, double reach) {
  double extent = reach;
  for (const TruthTriangle& t : triangles)
    for (const glm::dvec3& p : t.corners)
      extent = std::max(extent, std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
  return extent;
}

/// TriangleLeaf::clear. What doubles round off of volumes within the extent E, or of whether a
/// point lies in a plane, is below 2^-42 E^3: edge functions are products of coordinates up to 4 E,
/// each three roundings off, 2^-45 E^2; three of them are multiplied by 2 E.
std::vector<float> clearOf(const std::vector<TruthTriangle>& triangles, double extent,
                           const std::vector<double>& heights) {
  if (heights.empty()) return std::vector(triangles.size(), HUGE_VALF);
  std::vector<float> clear;
  clear.reserve(triangles.size());
  for (size_t i = 0; i < triangles.size(); ++i) {
    const auto& c = triangles[i].corners;
    const double area = glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));
    const double volume = 2 * area * heights[i] + 0x1p-38 * extent * extent * extent;
    clear.push_back(std::nextafter(float(volume), HUGE_VALF));
  }
  return clear;
}

}  // namespace

Bvh::Bvh(const std::vector<TruthTriangle>& triangles, double reach,
         const std::vector<double>& heights)
    : Bvh(triangles, heights, extentOf(triangles, reach)) {}

Bvh::Bvh(const std::vector<TruthTriangle>& triangles, const std::vector<double>& heights,
         double extent)
    : m_triangles(triangles), m_tree(triangles, extent, clearOf(triangles, extent, heights)) {}

void Bvh::hits(const TruthRay& ray, const Judge& judge, std::vector<TruthHit>& out,
               const BoxWalks& walks) const {
  struct Context {
    RaySearch search;
    const Judge& judge;
  } context{{m_triangles, ray, out}, judge};
  if (m_tree.empty()) return;
  const glm::dvec3 &o = ray.origin, &d = ray.direction;
  walks.ray(
      m_tree.view(), {{o.x, o.y, o.z}, {d.x, d.y, d.z}, ray.tMax, ray.own},
      [](void* self, uint32_t triangle) {
        Context& c = *static_cast<Context*>(self);
        c.search.test(triangle, c.judge);
        return c.search.walkTo();
      },
      &context);
  context.search.finish();
}

void Bvh::hitsOfAll(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
                    const Judge& judge, std::vector<TruthHit>& out) {
  RaySearch search(triangles, ray, out);
  for (uint32_t i = 0; i < triangles.size(); ++i)
    if (i != ray.own) search.test(i, judge);
  search.finish();
}

}  // namespace sb
