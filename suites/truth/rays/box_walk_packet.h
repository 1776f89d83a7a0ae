// Rays that walk together: boxes and triangles are sorted out for all of them at once, by intervals
// that hold each ray's own numbers; what passes is tested with each ray.
#pragma once

#include "suites/truth/rays/box_walk_bundle.h"

namespace sb {
namespace {

/// Which boxes any ray of a bundle may meet.
class BoxFilter {
 public:
  explicit BoxFilter(const Bundle& b) : m_bundle(b) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool back = b.negative[axis];
      m_near[axis] = back ? axis + 3 : axis;
      m_far[axis] = back ? axis : axis + 3;
      const Interval origin(floats(b.origin[axis])), inverse(floats(b.inverse[axis]));
      // Boxes are entered soonest from the origins nearest to them, and left last from the
      // farthest.
      m_soonest[axis] = back ? origin.low : origin.high;
      m_latest[axis] = back ? origin.high : origin.low;
      m_low[axis] = inverse.low, m_high[axis] = inverse.high;
    }
  }
  /// `from`: how far away they begin at least.
  [[gnu::always_inline]] uint32_t operator()(const BoxNode& node, float end, Floats& from) const {
    const auto* b = reinterpret_cast<const Floats*>(node.bounds);
    Floats to = Floats{} + end;
    from = Floats{};
    for (int axis = 0; axis < 3; ++axis) {
      const Floats enter = b[m_near[axis]] - m_soonest[axis];
      const Floats leave = b[m_far[axis]] - m_latest[axis];
      from = larger(from, smaller(enter * m_low[axis], enter * m_high[axis]));
      to = smaller(to, larger(leave * m_low[axis], leave * m_high[axis]));
    }
    return bits(from * kLess <= to * kMore);
  }
  /// Rays that may meet one of them.
  [[gnu::always_inline]] uint32_t rays(const BoxNode& node, uint32_t box) const {
    Floats enter{}, leave = floats(m_bundle.ends);
    for (int axis = 0; axis < 3; ++axis) {
      const Floats origin = floats(m_bundle.origin[axis]), inverse = floats(m_bundle.inverse[axis]);
      enter = larger(enter, (node.bounds[m_near[axis]][box] - origin) * inverse);
      leave = smaller(leave, (node.bounds[m_far[axis]][box] - origin) * inverse);
    }
    return bits(enter * kLess <= leave * kMore);
  }

 private:
  static const Floats& floats(const float* values) {
    return *reinterpret_cast<const Floats*>(values);
  }

  const Bundle& m_bundle;
  int m_near[3], m_far[3];  ///< of BoxNode::bounds, where rays enter and leave
  float m_soonest[3], m_latest[3];
  float m_low[3], m_high[3];
};

/// Trees of large scenes do not fit into caches: what will be visited is sent for early.
[[gnu::always_inline]] inline void prefetch(const BoxTreeView& tree, uint32_t child) {
  const bool leaf = child & kLeafChild;
  const char* at = leaf ? reinterpret_cast<const char*>(&tree.leaves[child & ~kLeafChild])
                        : reinterpret_cast<const char*>(&tree.nodes[child]);
  for (uint32_t line = 0; line < sizeof(BoxNode); line += 64) __builtin_prefetch(at + line);
}

/// A walk of one bundle.
class BundleWalk {
 public:
  BundleWalk(const BoxTreeView& tree, WalkPacket& packet, uint32_t rays, int largest,
             PacketCandidate candidate, void* search)
      : m_tree(tree),
        m_packet(packet),
        m_bundle(packet, rays, largest, tree.margin),
        m_boxes(m_bundle),
        m_candidate(candidate),
        m_search(search),
        m_walking(rays) {}

  void walk() {
    m_end = Interval(ends()).high;
    m_stack[0] = {m_tree.root, m_walking, 0};
    m_depth = 1;
    while (m_depth > 0) {
      const Entry entry = m_stack[--m_depth];
      const uint32_t entering = entry.rays & m_walking;
      if (entry.from * kLess > m_end || entering == 0) continue;
      if (!(entry.child & kLeafChild))
        enter(m_tree.nodes[entry.child], entering);
      else if (test(m_tree.leaves[entry.child & ~kLeafChild], entering)) {
        m_end = Interval(ends()).high;
        m_walking = bits(ends() >= 0);
        if (m_walking == 0) return;
      }
    }
  }

 private:
  struct Entry {
    uint32_t child;
    uint32_t rays;  ///< that may meet it
    float from;
  };

  const Floats& ends() const { return *reinterpret_cast<const Floats*>(m_bundle.ends); }

  [[gnu::always_inline]] void enter(const BoxNode& node, uint32_t entering) {
    const uint32_t begin = m_depth;
    Floats from;
    for (uint32_t hit = m_boxes(node, m_end, from); hit != 0; hit &= hit - 1) {
      const auto c = uint32_t(__builtin_ctz(hit));
      const uint32_t rays = m_boxes.rays(node, c) & entering;
      if (rays == 0) continue;
      prefetch(m_tree, node.child[c]);
      // Farther ones lie deeper.
      uint32_t place = m_depth++;
      for (; place > begin && m_stack[place - 1].from < from[c]; --place)
        m_stack[place] = m_stack[place - 1];
      m_stack[place] = {node.child[c], rays, from[c]};
    }
  }
  /// Did a ray's end come nearer?
  [[gnu::always_inline]] bool test(const TriangleLeaf& leaf, uint32_t entering) {
    const auto& numbers = *reinterpret_cast<const FourInts*>(leaf.triangle);
    const uint32_t triangles =
        ~bits((numbers == int(m_bundle.own)) | (numbers == int(kNoTriangle))) & 15;
    // With whichever there are fewer of, side by side.
    constexpr uint32_t kHalf = (1u << kLanes) - 1;
    const int halves = ((entering & kHalf) != 0) + ((entering & ~kHalf) != 0);
    bool nearer = false;
    if (__builtin_popcount(entering) <= halves * __builtin_popcount(triangles)) {
      for (uint32_t left = entering; left != 0; left &= left - 1)
        nearer |= testRay(leaf, uint32_t(__builtin_ctz(left)));
      return nearer;
    }
    for (uint32_t left = triangles; left != 0; left &= left - 1)
      for (uint32_t h = 0; h < 2; ++h)
        if ((entering >> (h * kLanes) & kHalf) != 0)
          nearer |= testTriangle(leaf, uint32_t(__builtin_ctz(left)), h, entering);
    return nearer;
  }
  [[gnu::always_inline]] bool testRay(const TriangleLeaf& leaf, uint32_t r) {
    const Bundle& b = m_bundle;
    const Sheared sheared(triangles(leaf), b.k, b.ox[r], b.oy[r], b.oz[r], b.sx[r], b.sy[r]);
    uint32_t met = sheared.candidates() & ~own(leaf, m_packet.own[r]);
    if (met == 0) return false;
    const auto clear =
        __builtin_convertvector(*reinterpret_cast<const FourFloats*>(leaf.clear), Doubles);
    if ((met & sheared.stopping(Doubles{} + b.span[r], clear)) != 0) return stop(r);
    bool nearer = false;
    for (; met != 0 && b.ends[r] >= 0; met &= met - 1)
      nearer |= ask(leaf.triangle[__builtin_ctz(met)], r);
    return nearer;
  }
  [[gnu::always_inline]] bool testTriangle(const TriangleLeaf& leaf, uint32_t t, uint32_t h,
                                           uint32_t entering) {
    const Bundle& b = m_bundle;
    const Sheared sheared([&](int i, int axis) { return leaf.corner[i][axis][t]; }, b.k,
                          half(b.ox, h), half(b.oy, h), half(b.oz, h), half(b.sx, h),
                          half(b.sy, h));
    uint32_t met = sheared.candidates() << (h * kLanes) & entering;
    if (met == 0) return false;
    const uint32_t stopping = sheared.stopping(half(b.span, h), Doubles{} + double(leaf.clear[t]))
                              << (h * kLanes);
    bool nearer = false;
    for (; met != 0; met &= met - 1) {
      const auto r = uint32_t(__builtin_ctz(met));
      if (m_packet.own[r] == leaf.triangle[t] || b.ends[r] < 0) continue;
      nearer |= (stopping >> r & 1) != 0 ? stop(r) : ask(leaf.triangle[t], r);
    }
    return nearer;
  }
  bool stop(uint32_t ray) {
    m_packet.stopped |= 1u << ray;
    m_bundle.ends[ray] = -1;
    return true;
  }
  bool ask(uint32_t triangle, uint32_t ray) {
    const double t = m_candidate(m_search, ray, triangle);
    float& end = m_bundle.ends[ray];
    const float before = end;
    end = t < 0 ? -1 : smaller(end, float(walkEnd(t, m_bundle.length[ray], m_tree.margin)));
    return end < before;
  }

  const BoxTreeView& m_tree;
  WalkPacket& m_packet;
  Bundle m_bundle;
  const BoxFilter m_boxes;
  const PacketCandidate m_candidate;
  void* const m_search;
  uint32_t m_walking;  ///< rays that did not end
  float m_end;         ///< the farthest one's
  uint32_t m_depth = 0;
  Entry m_stack[kTreeDepth * (kBoxes - 1) + 1];
};

void walkPacket(const BoxTreeView& tree, WalkPacket& packet, PacketCandidate candidate,
                void* search) {
  const Classes classes(packet);
  packet.stopped = 0;
  for (uint32_t left = packet.rays; left != 0;) {
    const auto first = uint32_t(__builtin_ctz(left));
    const uint32_t rays = classes.like(first) & left;
    left &= ~rays;
    BundleWalk(tree, packet, rays, int(classes.of[first] & Classes::kLargest), candidate, search)
        .walk();
  }
}

}  // namespace
}  // namespace sb
