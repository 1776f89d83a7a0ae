// Brute-force shadow rays in double, for scenes of a few triangles: what a pixel shows and whether
// light reaches it, with a margin. A point is Lit or Dark when every ray of a small bundle around
// the shadow ray agrees, else Unsure: there the map may answer either way.
#pragma once

#include <optional>

#include "tests/techniques/cell.h"

namespace sb::test {

enum class Shadow : uint8_t { Lit, Dark, Unsure };

struct SurfacePoint {
  glm::dvec3 position;
  glm::dvec3 normal;  ///< of the triangle, unit, either side
};

class Tracer {
 public:
  /// Opaque instances alone, all of them casters.
  explicit Tracer(const Scene& scene);

  /// First surface behind the centre of a pixel (row 0 at the bottom).
  std::optional<SurfacePoint> pixel(uint32_t x, uint32_t y, rhi::Extent2D size) const;
  /// `radius`: half width of the bundle in world units. Casters nearer than `contact` leave it
  /// open.
  Shadow shadow(const SurfacePoint& point, const Light& light, double radius, double contact) const;

 private:
  struct Triangle {
    glm::dvec3 a, ab, ac, normal;
  };
  /// Distance to the nearest hit in (from, to), or nothing; triangles in the plane of `skip` apart.
  std::optional<std::pair<double, size_t>> nearest(const glm::dvec3& origin, const glm::dvec3& dir,
                                                   double from, double to,
                                                   const SurfacePoint* skip) const;
  const Scene& m_scene;
  std::vector<Triangle> m_triangles;
};

struct ShadowCounts {
  size_t lit = 0, dark = 0, unsure = 0, wrong = 0;
  std::string firstWrong;
};

/// Compares the visibility of the first opaque surface with the tracer: exactly 1 where Lit,
/// exactly 0 where Dark. `texels`: half width of the bundle. `light`: index into Scene::lights, all
/// of which touch the view.
ShadowCounts compareShadows(Cell& cell, uint32_t light, double texels = 1, double contact = 0);

}  // namespace sb::test
