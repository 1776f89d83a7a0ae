// Rays and triangles within walks: `intersect` and ShearedRay of watertight.h, operation by
// operation, so that what is sorted out here is what they would not find.
#pragma once

#include "suites/truth/rays/box_walk_vectors.h"

namespace sb {
namespace {

/// As ShearedRay: the largest component comes last.
struct Axes {
  int x, y, z;
  explicit Axes(int largest) : x((largest + 1) % 3), y((largest + 2) % 3), z(largest) {}
};

/// Which component is the largest, counted from `first`; as ShearedRay decides it.
template <class V, class Index>
[[gnu::always_inline]] inline Index largestOf(const V& x, const V& y, const V& z,
                                              const Index& first) {
  return x > y ? (x > z ? first : first + 2) : (y > z ? first + 1 : first + 2);
}

/// Sheared's corners: one ray, a leaf's triangles.
[[gnu::always_inline]] inline auto triangles(const TriangleLeaf& leaf) {
  return [&leaf](int i, int axis) -> const Doubles& {
    return *reinterpret_cast<const Doubles*>(leaf.corner[i][axis]);
  };
}
/// A bit where the leaf holds the triangle that a ray starts on. Asked of each by itself, it would
/// mislead the CPU's guesses.
[[gnu::always_inline]] inline uint32_t own(const TriangleLeaf& leaf, uint32_t triangle) {
  return bits(*reinterpret_cast<const FourInts*>(leaf.triangle) == int(triangle));
}

/// Three roundings of a distance.
constexpr float kLess = 1 - 0x3p-23f, kMore = 1 + 0x3p-23f;

/// Over the largest component of a direction, its sign being that of the component. Components that
/// are smaller shares move nothing by a margin within the scene.
template <class V>
[[gnu::always_inline]] inline V inverseOf(const V& share, bool negative) {
  const V least = V{} + 1e-18f;
  return (negative ? -1.0f : 1.0f) / larger(absolute(share), least);
}

/// How far to walk along a ray up to `t`, its direction's largest component being `length`: boxes
/// that begin behind need not be entered.
template <class V>
[[gnu::always_inline]] inline V walkEnd(const V& t, const V& length, double margin) {
  return t * length * (1 + 1e-5) + 2 * margin;
}

/// Triangles as rays see them: one ray and the triangles of a leaf, or one triangle and rays.
struct Sheared {
  Doubles x[3], y[3], z[3];
  Doubles edge[3];

  /// `corner` gives a coordinate of a corner.
  template <class Corner, class V>
  [[gnu::always_inline]] Sheared(const Corner& corner, const Axes& k, const V& ox, const V& oy,
                                 const V& oz, const V& sx, const V& sy) {
    for (int i = 0; i < 3; ++i) {
      z[i] = corner(i, k.z) - oz;
      x[i] = corner(i, k.x) - ox - sx * z[i];
      y[i] = corner(i, k.y) - oy - sy * z[i];
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      edge[i] = x[j] * y[l] - y[j] * x[l];
    }
  }
  /// Where the line may meet the triangle: up to the rules for edges.
  [[gnu::always_inline]] uint32_t candidates() const {
    const Longs inside = ((edge[0] >= 0) & (edge[1] >= 0) & (edge[2] >= 0)) |
                         ((edge[0] <= 0) & (edge[1] <= 0) & (edge[2] <= 0));
    return bits(inside);
  }
  /// Where the triangle stops the ray for sure (TriangleLeaf::clear). `span`: the way from the
  /// ray's beginning to its end. Volumes: of what the triangle spans with the beginning, and with
  /// the whole way; shearing keeps them.
  [[gnu::always_inline]] uint32_t stopping(const Doubles& span, const Doubles& clear) const {
    const Longs within = ((edge[0] > 0) & (edge[1] > 0) & (edge[2] > 0)) |
                         ((edge[0] < 0) & (edge[1] < 0) & (edge[2] < 0));
    const Doubles way = (edge[0] + edge[1] + edge[2]) * span;
    const Doubles before = edge[0] * z[0] + edge[1] * z[1] + edge[2] * z[2];
    const Doubles begun = way > 0 ? before : -before;
    const Longs stops = within & (begun > clear) & (absolute(way) > begun + clear);
    return bits(stops);
  }
};

}  // namespace
}  // namespace sb
