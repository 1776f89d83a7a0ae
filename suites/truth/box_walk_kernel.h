// The walk itself, included once per instruction set; `WALK` names the function.
#ifndef WALK
#error "define WALK"
#endif

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "suites/truth/box_walk.h"

namespace sb {
namespace {

using Floats = float __attribute__((vector_size(4 * kBoxes)));
using Ints = int __attribute__((vector_size(4 * kBoxes)));
using Doubles = double __attribute__((vector_size(8 * kLeafTriangles)));
using Longs = long long __attribute__((vector_size(8 * kLeafTriangles)));

/// One bit per place.
[[gnu::always_inline]] inline uint32_t bits(const Ints& mask) {
#if defined(__AVX__)
  return uint32_t(_mm256_movemask_ps(__m256(mask)));
#elif defined(__SSE2__)
  const auto* half = reinterpret_cast<const __m128*>(&mask);
  return uint32_t(_mm_movemask_ps(half[0]) | _mm_movemask_ps(half[1]) << 4);
#else
  uint32_t bits = 0;
  for (uint32_t i = 0; i < kBoxes; ++i) bits |= uint32_t(mask[i] & 1) << i;
  return bits;
#endif
}
[[gnu::always_inline]] inline uint32_t bits(const Longs& mask) {
#if defined(__AVX__)
  return uint32_t(_mm256_movemask_pd(__m256d(mask)));
#elif defined(__SSE2__)
  const auto* half = reinterpret_cast<const __m128d*>(&mask);
  return uint32_t(_mm_movemask_pd(half[0]) | _mm_movemask_pd(half[1]) << 2);
#else
  uint32_t bits = 0;
  for (uint32_t i = 0; i < kLeafTriangles; ++i) bits |= uint32_t(mask[i] & 1) << i;
  return bits;
#endif
}

/// Triangles of the leaf that the ray's line may meet: `intersect` in watertight.h up to its rules
/// for edges, operation by operation.
[[gnu::always_inline]] inline uint32_t candidates(const TriangleLeaf& leaf, const WalkRay& ray) {
  Doubles x[3], y[3];
  for (int i = 0; i < 3; ++i) {
    const auto* corner = reinterpret_cast<const Doubles*>(leaf.corner[i]);
    const Doubles pz = corner[ray.kz] - ray.oz;
    x[i] = corner[ray.kx] - ray.ox - ray.sx * pz;
    y[i] = corner[ray.ky] - ray.oy - ray.sy * pz;
  }
  const Doubles a = x[1] * y[2] - y[1] * x[2];
  const Doubles b = x[2] * y[0] - y[2] * x[0];
  const Doubles c = x[0] * y[1] - y[0] * x[1];
  const Longs inside = ((a >= 0) & (b >= 0) & (c >= 0)) | ((a <= 0) & (b <= 0) & (c <= 0));
  return bits(inside);
}

}  // namespace

void WALK(const BoxTreeView& tree, const WalkRay& ray, Candidate candidate, void* search) {
  struct Entry {
    uint32_t child;
    float from;
  };
  Entry stack[kTreeDepth * (kBoxes - 1) + 1];
  uint32_t depth = 0;
  const Floats zero{};
  const Floats ox = zero + ray.origin[0], oy = zero + ray.origin[1], oz = zero + ray.origin[2];
  const Floats ix = zero + ray.inverse[0], iy = zero + ray.inverse[1], iz = zero + ray.inverse[2];
  const int nearX = ray.inverse[0] < 0 ? 3 : 0, nearY = ray.inverse[1] < 0 ? 4 : 1,
            nearZ = ray.inverse[2] < 0 ? 5 : 2;
  const int farX = 3 - nearX, farY = 5 - nearY, farZ = 7 - nearZ;
  float end = ray.end;
  uint32_t child = tree.root;
  for (;;) {
    while (!(child & kLeafChild)) {
      const BoxNode& node = tree.nodes[child];
      const auto* bounds = reinterpret_cast<const Floats*>(node.bounds);
      const Floats x0 = (bounds[nearX] - ox) * ix, x1 = (bounds[farX] - ox) * ix;
      const Floats y0 = (bounds[nearY] - oy) * iy, y1 = (bounds[farY] - oy) * iy;
      const Floats z0 = (bounds[nearZ] - oz) * iz, z1 = (bounds[farZ] - oz) * iz;
      Floats from = x0 > y0 ? x0 : y0, to = x1 < y1 ? x1 : y1;
      from = from > z0 ? from : z0, to = to < z1 ? to : z1;
      from = from > zero ? from : zero;
      const Floats ends = zero + end;
      to = to < ends ? to : ends;
      // Three roundings on either side.
      uint32_t hit = bits(from * (1 - 0x3p-23f) <= to * (1 + 0x3p-23f));
      if (hit == 0) break;
      uint32_t nearest = uint32_t(__builtin_ctz(hit));
      for (hit &= hit - 1; hit != 0; hit &= hit - 1) {
        const uint32_t other = uint32_t(__builtin_ctz(hit));
        const bool nearer = from[other] < from[nearest];
        const uint32_t later = nearer ? nearest : other;
        stack[depth++] = {node.child[later], from[later]};
        nearest = nearer ? other : nearest;
      }
      child = node.child[nearest];
    }
    if (child & kLeafChild) {
      const TriangleLeaf& leaf = tree.leaves[child & ~kLeafChild];
      for (uint32_t hit = candidates(leaf, ray); hit != 0; hit &= hit - 1) {
        end = candidate(search, leaf.triangle[__builtin_ctz(hit)], end);
        if (end < 0) return;
      }
    }
    do {
      if (depth == 0) return;
      --depth;
    } while (stack[depth].from * (1 - 0x3p-23f) > end);
    child = stack[depth].child;
  }
}

}  // namespace sb
