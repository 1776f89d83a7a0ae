#include "techniques/partition/light_overlap.h"

#include <algorithm>
#include <cmath>

#include "techniques/partition/light_order.h"
#include "techniques/scene/box.h"

namespace sb {
namespace {

constexpr size_t kExactOutline = 256;  ///< vertices; larger meshes show the outline of their box
constexpr double kTouching = 1e-6;     ///< of the extent of a pair: nearer than this is one plane

enum class Order { AFirst, BFirst, Neither, Unknown };

/// Where the light is: a point, or a direction toward it.
struct LightPoint {
  bool directional;
  glm::dvec3 at;
  /// Positive on the side of the plane that the normal points to.
  double side(const Plane& p) const {
    return glm::dot(p.normal, at) - (directional ? 0 : p.offset);
  }
};

LightNode makeNode(const SceneView& view, const LightView& light, uint32_t i) {
  const Scene& scene = view.scene();
  const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
  const glm::dmat4& toWorld = view.placed().toWorld(i);
  const glm::dmat3 linear(toWorld);
  const glm::dvec3 translation = glm::dvec3(toWorld[3]) - view.camera().eye;
  LightNode node{.instance = i};
  for (int c = 0; c < 8; ++c)
    node.corners[size_t(c)] = linear * glm::dvec3(c & 1 ? mesh.boundsMax.x : mesh.boundsMin.x,
                                                  c & 2 ? mesh.boundsMax.y : mesh.boundsMin.y,
                                                  c & 4 ? mesh.boundsMax.z : mesh.boundsMin.z) +
                              translation;
  node.plane = planeOf(mesh);
  if (node.plane) {
    const glm::dvec3 point = linear * (node.plane->normal * node.plane->offset) + translation;
    glm::dvec3 n = node.plane->normal;
    n = glm::cross(linear[1], linear[2]) * n.x + glm::cross(linear[2], linear[0]) * n.y +
        glm::cross(linear[0], linear[1]) * n.z;
    if (glm::length(n) > 0) n = glm::normalize(n);
    node.plane = Plane{n, glm::dot(n, point)};
  }
  std::vector<glm::dvec3> points(node.corners.begin(), node.corners.end());
  if (mesh.positions.size() <= kExactOutline) {
    points.clear();
    for (const glm::vec3& p : mesh.positions)
      points.push_back(linear * glm::dvec3(p) + translation);
  }
  const glm::dmat4 toClip(light.toClip);
  const glm::dvec3 origin(light.origin);
  node.nearest = 1e300;
  node.farthest = -1e300;
  bool behind = false;
  for (const glm::dvec3& p : points) {
    const glm::dvec4 clip = toClip * glm::dvec4(p - origin, 1);
    node.nearest = std::min(node.nearest, lightDepth(light, p));
    node.farthest = std::max(node.farthest, lightDepth(light, p));
    behind |= clip.w <= 0;
    node.hull.emplace_back(glm::dvec2(clip) / clip.w);
  }
  // What reaches behind a local light may be anywhere on the map.
  if (behind) node.hull = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  node.hull = convexHull(std::move(node.hull));
  return node;
}

/// On which side of a plane that faces the light all corners lie.
Order sideOf(const Plane& plane, const LightPoint& light, const LightNode& of, double tolerance,
             Order before, Order behind) {
  const double side = light.side(plane);
  if (std::abs(side) <= (light.directional ? 1e-9 : tolerance)) return Order::Unknown;
  bool noneBefore = true, noneBehind = true;
  for (const glm::dvec3& p : of.corners) {
    const double d = (glm::dot(plane.normal, p) - plane.offset) * (side > 0 ? 1 : -1);
    noneBefore &= d <= tolerance;
    noneBehind &= d >= -tolerance;
  }
  if (noneBefore && noneBehind) return Order::Neither;
  return noneBehind ? before : noneBefore ? behind : Order::Unknown;
}

Order orderOf(const LightNode& a, const LightNode& b, const LightPoint& light) {
  Box boxA, boxB;
  for (const glm::dvec3& p : a.corners) boxA.add(p);
  for (const glm::dvec3& p : b.corners) boxB.add(p);
  const double tolerance =
      kTouching * (glm::length(boxA.high - boxA.low) + glm::length(boxB.high - boxB.low));
  if (a.plane)
    if (const Order o = sideOf(*a.plane, light, b, tolerance, Order::BFirst, Order::AFirst);
        o != Order::Unknown)
      return o;
  if (b.plane)
    if (const Order o = sideOf(*b.plane, light, a, tolerance, Order::AFirst, Order::BFirst);
        o != Order::Unknown)
      return o;
  if (a.farthest <= b.nearest + tolerance) return Order::AFirst;
  if (b.farthest <= a.nearest + tolerance) return Order::BFirst;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool aIsLow : {true, false}) {
      const Box& low = aIsLow ? boxA : boxB;
      const Box& high = aIsLow ? boxB : boxA;
      if (low.high[axis] > high.low[axis] + tolerance) continue;
      Plane plane;
      plane.normal[axis] = 1;
      plane.offset = 0.5 * (low.high[axis] + high.low[axis]);
      const double side = light.side(plane);
      if (std::abs(side) <= (light.directional ? 1e-9 : tolerance)) continue;
      return (side > 0) == aIsLow ? Order::BFirst : Order::AFirst;
    }
  return Order::Unknown;
}

}  // namespace

LightOverlap lightOverlap(const SceneView& view, const LightView& light) {
  const Scene& scene = view.scene();
  std::vector<uint8_t> casts(scene.instances.size()), receives(scene.instances.size());
  for (const uint32_t i : light.translucent) casts[i] = 1;
  const auto lit = [&](uint32_t i) {
    return !scene.materials[scene.meshes[scene.instances[i].mesh].material].unlit;
  };
  for (const uint32_t i : view.effects().visibleTranslucent) receives[i] = lit(i);
  for (const uint32_t i : view.effects().visibleOpaque) receives[i] = casts[i] && lit(i);

  LightOverlap out;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    if (!casts[i] && !receives[i]) continue;
    out.nodes.push_back(makeNode(view, light, i));
    out.nodes.back().casts = casts[i] != 0;
    out.nodes.back().receives = receives[i] != 0;
  }
  out.successors.resize(out.nodes.size());

  const Light& source = view.placed().light(light.light);
  const LightPoint point{source.type == LightType::Directional,
                         source.type == LightType::Directional
                             ? -source.direction
                             : source.position - view.camera().eye};
  // Sweep along x of the map.
  struct Interval {
    double low, high;
    uint32_t node;
  };
  std::vector<Interval> intervals;
  for (uint32_t n = 0; n < out.nodes.size(); ++n) {
    const auto& hull = out.nodes[n].hull;
    if (hull.size() < 3) continue;
    const auto [low, high] = std::ranges::minmax_element(hull, {}, &glm::dvec2::x);
    intervals.push_back({low->x, high->x, n});
  }
  std::ranges::sort(intervals, {}, &Interval::low);
  std::vector<Interval> active;
  for (const Interval& i : intervals) {
    std::erase_if(active, [&](const Interval& a) { return a.high <= i.low; });
    for (const Interval& j : active) {
      const LightNode &a = out.nodes[i.node], &b = out.nodes[j.node];
      if (!(a.casts && b.receives) && !(b.casts && a.receives)) continue;
      if (!overlap(a.hull, b.hull, 1e-9)) continue;
      const Order order = orderOf(a, b, point);
      if (order == Order::AFirst || order == Order::Unknown)
        out.successors[i.node].push_back(j.node);
      if (order == Order::BFirst || order == Order::Unknown)
        out.successors[j.node].push_back(i.node);
    }
    active.push_back(i);
  }
  return out;
}

}  // namespace sb
