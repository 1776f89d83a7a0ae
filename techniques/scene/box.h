// Axis-aligned boxes, in double.
#pragma once

#include <limits>

#include "techniques/scene/placed_scene.h"

namespace sb {

/// Empty until something is added.
struct Box {
  glm::dvec3 low = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 high = glm::dvec3(-std::numeric_limits<double>::infinity());

  bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
  void add(const glm::dvec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
  void add(const Box& o) { low = glm::min(low, o.low), high = glm::max(high, o.high); }
  void grow(double by) { low -= glm::dvec3(by), high += glm::dvec3(by); }
  bool touches(const Box& o) const {
    return glm::all(glm::lessThanEqual(low, o.high)) && glm::all(glm::lessThanEqual(o.low, high));
  }
  Box clippedTo(const Box& o) const { return {glm::max(low, o.low), glm::min(high, o.high)}; }
  glm::dvec3 center() const { return 0.5 * (low + high); }
  /// Of the sphere around the box.
  double radius() const { return 0.5 * glm::length(high - low); }
  /// Bit i of `number`: the higher end of axis i.
  glm::dvec3 corner(int number) const {
    return {number & 1 ? high.x : low.x, number & 2 ? high.y : low.y, number & 4 ? high.z : low.z};
  }
};

/// Around the eight transformed corners of a box in mesh space, relative to `origin` (subtracted in
/// double, so that scenes far from zero lose nothing), through the rotation `axes` (rows: the
/// axes).
Box transformedBox(const Box& box, const glm::dmat4& toWorld,
                   const glm::dvec3& origin = glm::dvec3(0),
                   const glm::dmat3& axes = glm::dmat3(1));
/// Of a mesh, in its own space.
Box meshBox(const Mesh& mesh);
/// Of a medium, in its own space.
inline constexpr Box kMediumBox{glm::dvec3(0), glm::dvec3(1)};

/// Of an instance where it stands in `scene`, or now.
Box instanceBox(const Scene& scene, const Instance& instance,
                const glm::dvec3& origin = glm::dvec3(0));
Box instanceBox(const PlacedScene& placed, uint32_t instance, const glm::dvec3& origin,
                const glm::dmat3& axes = glm::dmat3(1));
/// Of all instances, now.
Box instancesBox(const PlacedScene& placed, const glm::dvec3& origin);
/// Of all instances and media.
Box sceneBox(const Scene& scene);

}  // namespace sb
