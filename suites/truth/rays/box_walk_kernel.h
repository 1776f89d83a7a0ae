// The walks themselves, included once per instruction set; `WALKS` names the function that gives
// them.
#ifndef WALKS
#error "define WALKS"
#endif

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "suites/truth/rays/box_walk.h"

namespace sb {
namespace {

using Floats = float __attribute__((vector_size(4 * kBoxes)));
using Ints = int __attribute__((vector_size(4 * kBoxes)));
using FourInts = int __attribute__((vector_size(4 * kLeafTriangles)));
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
[[gnu::always_inline]] inline uint32_t bits(const FourInts& mask) {
#if defined(__SSE2__)
  return uint32_t(_mm_movemask_ps(__m128(mask)));
#else
  uint32_t bits = 0;
  for (uint32_t i = 0; i < kLeafTriangles; ++i) bits |= uint32_t(mask[i] & 1) << i;
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
[[gnu::always_inline]] inline uint32_t candidates(const TriangleLeaf& leaf, const WalkLine& ray) {
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
  // Asked of each by itself, the one that a shadow ray starts on would mislead the CPU's guesses.
  const FourInts own = *reinterpret_cast<const FourInts*>(leaf.triangle) == int(ray.own);
  return bits(inside) & ~bits(own);
}

/// Trees of large scenes do not fit into caches: what will be visited is sent for early.
[[gnu::always_inline]] inline void prefetch(const BoxTreeView& tree, uint32_t child) {
  const bool leaf = child & kLeafChild;
  const char* at = leaf ? reinterpret_cast<const char*>(&tree.leaves[child & ~kLeafChild])
                        : reinterpret_cast<const char*>(&tree.nodes[child]);
  for (uint32_t line = 0; line < sizeof(BoxNode); line += 64) __builtin_prefetch(at + line);
}

/// Three roundings of a distance.
constexpr float kLess = 1 - 0x3p-23f, kMore = 1 + 0x3p-23f;

struct Entry {
  uint32_t child;
  float from;
  uint32_t rays;  ///< of a packet that may meet it
};

/// What is still to be visited.
class Stack {
 public:
  /// Pushes the children whose bits are set, but for the nearest, which it gives.
  uint32_t pushAllButNearest(const BoxNode& node, uint32_t hit, const Floats& from) {
    uint32_t nearest = uint32_t(__builtin_ctz(hit));
    for (hit &= hit - 1; hit != 0; hit &= hit - 1) {
      const uint32_t other = uint32_t(__builtin_ctz(hit));
      const bool nearer = from[other] < from[nearest];
      const uint32_t later = nearer ? nearest : other;
      m_entries[m_depth++] = {node.child[later], from[later]};
      nearest = nearer ? other : nearest;
    }
    return node.child[nearest];
  }
  /// The next that begins before `end`; false if there is none.
  bool pop(uint32_t& child, float end) {
    do {
      if (m_depth == 0) return false;
      --m_depth;
    } while (m_entries[m_depth].from * kLess > end);
    child = m_entries[m_depth].child;
    return true;
  }

 private:
  Entry m_entries[kTreeDepth * (kBoxes - 1) + 1];
  uint32_t m_depth = 0;
};

/// Which of BoxNode::bounds a ray enters and leaves through.
struct Sides {
  int near[3], far[3];
  template <class Inverse>
  explicit Sides(const Inverse& inverse) {
    for (int axis = 0; axis < 3; ++axis) {
      near[axis] = inverse(axis) < 0 ? axis + 3 : axis;
      far[axis] = inverse(axis) < 0 ? axis : axis + 3;
    }
  }
};

// Vectors are returned by what is compiled into its caller alone: no ABI matters.
#pragma GCC diagnostic ignored "-Wpsabi"
[[gnu::always_inline]] inline Floats larger(const Floats& a, const Floats& b) {
  return a > b ? a : b;
}
[[gnu::always_inline]] inline Floats smaller(const Floats& a, const Floats& b) {
  return a < b ? a : b;
}

void walkRay(const BoxTreeView& tree, const WalkRay& ray, Candidate candidate, void* search) {
  Stack stack;
  const Floats zero{};
  const Floats ox = zero + ray.origin[0], oy = zero + ray.origin[1], oz = zero + ray.origin[2];
  const Floats ix = zero + ray.inverse[0], iy = zero + ray.inverse[1], iz = zero + ray.inverse[2];
  const Sides s([&](int axis) { return ray.inverse[axis]; });
  float end = ray.end;
  uint32_t child = tree.root;
  do {
    while (!(child & kLeafChild)) {
      const BoxNode& node = tree.nodes[child];
      const auto* b = reinterpret_cast<const Floats*>(node.bounds);
      const Floats from = larger(larger((b[s.near[0]] - ox) * ix, (b[s.near[1]] - oy) * iy),
                                 larger((b[s.near[2]] - oz) * iz, zero));
      const Floats to = smaller(smaller((b[s.far[0]] - ox) * ix, (b[s.far[1]] - oy) * iy),
                                smaller((b[s.far[2]] - oz) * iz, zero + end));
      const uint32_t hit = bits(from * kLess <= to * kMore);
      if (hit == 0) break;
      child = stack.pushAllButNearest(node, hit, from);
    }
    if (!(child & kLeafChild)) continue;
    const TriangleLeaf& leaf = tree.leaves[child & ~kLeafChild];
    for (uint32_t hit = candidates(leaf, ray.line); hit != 0; hit &= hit - 1) {
      const uint32_t triangle = leaf.triangle[__builtin_ctz(hit)];
      end = candidate(search, triangle, end);
      if (end < 0) return;
    }
  } while (stack.pop(child, end));
}

/// Least and greatest of a packet's rays.
struct Interval {
  float low, high;
  [[gnu::always_inline]] explicit Interval(const Floats& v) {
    const Ints halves{4, 5, 6, 7, 0, 1, 2, 3}, pairs{2, 3, 0, 1, 6, 7, 4, 5},
        singles{1, 0, 3, 2, 5, 4, 7, 6};
    Floats a = smaller(v, __builtin_shuffle(v, halves)),
           b = larger(v, __builtin_shuffle(v, halves));
    a = smaller(a, __builtin_shuffle(a, pairs)), b = larger(b, __builtin_shuffle(b, pairs));
    low = smaller(a, __builtin_shuffle(a, singles))[0];
    high = larger(b, __builtin_shuffle(b, singles))[0];
  }
};

/// A node's boxes are tested with all of the packet's rays at once, by intervals that hold each
/// ray's own distances; boxes that pass, with each ray.
void walkPacket(const BoxTreeView& tree, WalkPacket& packet, PacketCandidate candidate,
                void* search) {
  const Floats zero{};
  const auto* po = reinterpret_cast<const Floats*>(packet.origin);
  const auto* pi = reinterpret_cast<const Floats*>(packet.inverse);
  const auto& ends = *reinterpret_cast<const Floats*>(packet.end);
  const Interval origin[3] = {Interval(po[0]), Interval(po[1]), Interval(po[2])};
  const Interval inverse[3] = {Interval(pi[0]), Interval(pi[1]), Interval(pi[2])};
  const Sides s([&](int axis) { return inverse[axis].low; });
  // Boxes are entered soonest from the origins nearest to them, and left last from the farthest.
  const auto at = [&](int axis, bool entering) {
    return zero + ((inverse[axis].low < 0) == entering ? origin[axis].low : origin[axis].high);
  };
  const Floats o0[3] = {at(0, true), at(1, true), at(2, true)};
  const Floats o1[3] = {at(0, false), at(1, false), at(2, false)};
  const Floats low[3] = {zero + inverse[0].low, zero + inverse[1].low, zero + inverse[2].low};
  const Floats high[3] = {zero + inverse[0].high, zero + inverse[1].high, zero + inverse[2].high};
  float end = Interval(ends).high;
  uint32_t walking = bits(ends >= 0);
  Entry stack[kTreeDepth * (kBoxes - 1) + 1];
  uint32_t depth = 1;
  stack[0] = {tree.root, 0, (1u << kPacket) - 1};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    const uint32_t entering = entry.rays & walking;
    if (entry.from * kLess > end || entering == 0) continue;
    if (!(entry.child & kLeafChild)) {
      const BoxNode& node = tree.nodes[entry.child];
      const auto* b = reinterpret_cast<const Floats*>(node.bounds);
      const uint32_t begin = depth;
      Floats from = zero, to = zero + end;
      for (int axis = 0; axis < 3; ++axis) {
        const Floats enter = b[s.near[axis]] - o0[axis], leave = b[s.far[axis]] - o1[axis];
        from = larger(from, smaller(enter * low[axis], enter * high[axis]));
        to = smaller(to, larger(leave * low[axis], leave * high[axis]));
      }
      for (uint32_t hit = bits(from * kLess <= to * kMore); hit != 0; hit &= hit - 1) {
        const uint32_t c = uint32_t(__builtin_ctz(hit));
        Floats enter = zero, leave = ends;
        for (int axis = 0; axis < 3; ++axis) {
          enter = larger(enter, (node.bounds[s.near[axis]][c] - po[axis]) * pi[axis]);
          leave = smaller(leave, (node.bounds[s.far[axis]][c] - po[axis]) * pi[axis]);
        }
        const uint32_t rays = bits(enter * kLess <= leave * kMore) & entering;
        if (rays == 0) continue;
        prefetch(tree, node.child[c]);
        // Farther ones lie deeper.
        uint32_t place = depth++;
        for (; place > begin && stack[place - 1].from < from[c]; --place)
          stack[place] = stack[place - 1];
        stack[place] = {node.child[c], from[c], rays};
      }
      continue;
    }
    const TriangleLeaf& leaf = tree.leaves[entry.child & ~kLeafChild];
    bool shortened = false;
    for (uint32_t rays = entering; rays != 0; rays &= rays - 1) {
      const uint32_t r = uint32_t(__builtin_ctz(rays));
      for (uint32_t hit = candidates(leaf, packet.lines[r]); hit != 0; hit &= hit - 1) {
        const uint32_t triangle = leaf.triangle[__builtin_ctz(hit)];
        const float before = packet.end[r];
        packet.end[r] = candidate(search, r, triangle, before);
        shortened |= packet.end[r] < before;
        if (packet.end[r] < 0) break;
      }
    }
    if (!shortened) continue;
    end = Interval(ends).high;
    walking = bits(ends >= 0);
    if (end < 0) return;
  }
}

}  // namespace

BoxWalks WALKS() { return {walkRay, walkPacket}; }

}  // namespace sb
