// Boxes in world space, in double.
#pragma once

#include <limits>

#include "techniques/scene/scene.h"

namespace sb {

/// An axis-aligned box; empty until something is added.
struct Bounds {
  glm::dvec3 low = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 high = glm::dvec3(-std::numeric_limits<double>::infinity());

  bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
  void add(glm::dvec3 p) { low = glm::min(low, p), high = glm::max(high, p); }
  void add(const Bounds& o) { low = glm::min(low, o.low), high = glm::max(high, o.high); }
  void grow(double by) { low -= glm::dvec3(by), high += glm::dvec3(by); }
  bool touches(const Bounds& o) const {
    return glm::all(glm::lessThanEqual(low, o.high)) && glm::all(glm::lessThanEqual(o.low, high));
  }
  Bounds clippedTo(const Bounds& o) const { return {glm::max(low, o.low), glm::min(high, o.high)}; }
  glm::dvec3 center() const { return 0.5 * (low + high); }
  /// Of the sphere around the box.
  double radius() const { return 0.5 * glm::length(high - low); }
  glm::dvec3 corner(int i) const {
    return {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
  }
};

/// World box of the eight transformed corners of a box in mesh space, relative to `origin`
/// (subtracted in double, so that scenes far from zero lose nothing).
Bounds transformedBox(glm::dvec3 low, glm::dvec3 high, const glm::dmat4& toWorld,
                   glm::dvec3 origin = glm::dvec3(0));
Bounds instanceBox(const Scene& scene, const Instance& instance, glm::dvec3 origin = glm::dvec3(0));
/// Of all instances and media.
Bounds sceneBox(const Scene& scene);

}  // namespace sb
