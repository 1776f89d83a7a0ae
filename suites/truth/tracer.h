// A scene ready to be traced: triangles relative to the eye in double, and a tree of boxes over
// them (decision D7), so that a ray meets exactly the triangles that testing each of them would
// find.
#pragma once

#include <memory>
#include <optional>

#include "suites/truth/truth.h"
#include "techniques/plan/lookup_reach.h"

namespace sb {

class Tracer {
 public:
  /// The scene must outlive the tracer. Throws std::runtime_error when Embree refuses.
  Tracer(const Scene& scene, uint32_t width, uint32_t height, unsigned threads = 0);
  ~Tracer();

  /// Empty when interrupted.
  std::optional<Truth> trace(const TruthSettings& settings) const;

  /// The picture alone, one ray a pixel and the shadow rays it needs: what ray tracing costs.
  /// `raysPerLight`: to lights with an extent, a power of two. `rays` counts them all if given.
  std::vector<float> image(uint32_t raysPerLight = 1, uint64_t* rays = nullptr) const;

  /// Memory of triangles and tree.
  uint64_t bytes() const;

  /// A surface point that the camera sees.
  struct Point {
    glm::dvec3 position;  ///< relative to the eye
    glm::dvec3 normal;    ///< geometric, unit, toward the viewer
    uint32_t instance;
    uint32_t triangle;    ///< number in the tracer's list: skipped by shadow rays from here
    bool translucent;     ///< to the light
  };
  /// The surface at a pixel's centre in a layer (0..4); row 0 at the bottom.
  std::optional<Point> pointAt(uint32_t x, uint32_t y, uint32_t layer) const;
  /// RGB share of a light that arrives.
  glm::dvec3 visibility(uint32_t light, const Point& point,
                        const AreaSampling& sampling = {}) const;
  /// Coordinates of a point in a map of the light whose lookups reach `reach`, in units of that
  /// reach: two lookups overlap when both coordinates are nearer than 2. z: cube face, else 0.
  glm::dvec3 mapCoordinates(uint32_t light, const Point& point, const LookupReach& reach) const;

  struct Range {
    glm::dvec3 low, high;
  };
  /// Least and greatest visibility over the point and points of its plane around it within the
  /// reach (a square ring of 16 and one of 8 at half the width, shifted along the light's direction
  /// onto the point's plane): equal when no shadow edge lies within the reach. What the point's own
  /// instance throws over less than four half widths does not count, nor what darkens its plane but
  /// not the surface that bends away from it: a curved surface that shadows itself there is the
  /// lookup's fault.
  Range visibilityNear(uint32_t light, const Point& point, const LookupReach& reach) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

}  // namespace sb
