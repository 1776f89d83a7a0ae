// Does a ray meet a triangle? Watertight (the idea of Woop, Benthin, Wald, "Watertight Ray/Triangle
// Intersection", JCGT 2013): the triangle is sheared into a space where the ray is the z axis, and
// three edge functions tell whether the origin lies inside. Neighbours compute the same edge function
// with opposite sign, so nothing falls between them. A ray through an edge itself meets one of the
// two: on which side it counts as lying follows from the edge's direction alone, as rasterisers
// decide it.
#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

namespace sb {

/// A ray in a space sheared to it. Scalar: double, or float to see what precision does.
template <class Scalar>
struct ShearedRay {
  using Vec = glm::vec<3, Scalar>;
  int kx, ky, kz;
  Scalar sx, sy;
  Scalar dz;          ///< the direction along kz; its inverse scales z
  Scalar ox, oy, oz;  ///< the origin, in the order of kx, ky, kz

  ShearedRay() = default;
  ShearedRay(const Vec& o, const Vec& d) {
    head(d);
    start(o);
  }
  void head(const Vec& d) {
    const Vec a = glm::abs(d);
    kz = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    const Scalar* direction = glm::value_ptr(d);
    dz = direction[kz];
    sx = direction[kx] / dz;
    sy = direction[ky] / dz;
  }
  /// Having a heading already.
  void start(const Vec& o) {
    const Scalar* origin = glm::value_ptr(o);
    ox = origin[kx], oy = origin[ky], oz = origin[kz];
  }
};

template <class Scalar>
struct TriangleHit {
  Scalar t;     ///< along the ray's direction
  Scalar b, c;  ///< weights of the second and third vertex
  bool front;   ///< seen from the side from which the vertices run counter-clockwise
};

template <class Scalar>
std::optional<TriangleHit<Scalar>> intersect(const ShearedRay<Scalar>& ray,
                                             const std::array<glm::vec<3, Scalar>, 3>& triangle) {
  Scalar x[3], y[3], z[3];
  const Scalar sz = Scalar(1) / ray.dz;
  for (int i = 0; i < 3; ++i) {
    const Scalar* corner = glm::value_ptr(triangle[size_t(i)]);
    const Scalar pz = corner[ray.kz] - ray.oz;
    z[i] = sz * pz;
    x[i] = corner[ray.kx] - ray.ox - ray.sx * pz;
    y[i] = corner[ray.ky] - ray.oy - ray.sy * pz;
  }
  // Edge i lies opposite to vertex i. a b - c d is exactly the negative of c d - a b.
  Scalar e[3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    e[i] = x[j] * y[k] - y[j] * x[k];
  }
  const bool negative = e[0] < 0 || e[1] < 0 || e[2] < 0;
  if (negative && (e[0] > 0 || e[1] > 0 || e[2] > 0)) return {};
  const Scalar sum = e[0] + e[1] + e[2];
  if (sum == 0) return {};
  for (int i = 0; i < 3; ++i) {
    if (e[i] != 0) continue;
    // Directed as if the triangle ran counter-clockwise, one of two neighbours sees it upward.
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Scalar dx = negative ? x[j] - x[k] : x[k] - x[j];
    const Scalar dy = negative ? y[j] - y[k] : y[k] - y[j];
    if (!(dy > 0 || (dy == 0 && dx < 0))) return {};
  }
  const Scalar inverse = Scalar(1) / sum;
  TriangleHit<Scalar> hit;
  hit.t = (e[0] * z[0] + e[1] * z[1] + e[2] * z[2]) * inverse;
  hit.b = e[1] * inverse;
  hit.c = e[2] * inverse;
  // Shearing keeps the handedness of (kx, ky, kz); the ray looks along +z or -z of it.
  hit.front = (sum < 0) == (sz > 0);
  return hit;
}

}  // namespace sb
