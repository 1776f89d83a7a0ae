// The walks themselves, included once per instruction set; `WALKS` names the function that gives
// them.
#ifndef WALKS
#error "define WALKS"
#endif

#include "suites/truth/rays/box_walk_packet.h"

namespace sb {
namespace {

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
  struct Entry {
    uint32_t child;
    float from;
  };
  Entry m_entries[kTreeDepth * (kBoxes - 1) + 1];
  uint32_t m_depth = 0;
};

void walkRay(const BoxTreeView& tree, const WalkRay& ray, Candidate candidate, void* search) {
  const double* o = ray.origin;
  const double* d = ray.direction;
  const double size[3] = {absolute(d[0]), absolute(d[1]), absolute(d[2])};
  const Axes k(largestOf(size[0], size[1], size[2], 0));
  const double sx = d[k.x] / d[k.z], sy = d[k.y] / d[k.z];
  float inverse[3];
  inverse[k.x] = inverseOf(float(sx), d[k.x] < 0);
  inverse[k.y] = inverseOf(float(sy), d[k.y] < 0);
  inverse[k.z] = d[k.z] < 0 ? -1 : 1;
  int near[3], far[3];
  for (int axis = 0; axis < 3; ++axis) {
    near[axis] = d[axis] < 0 ? axis + 3 : axis;
    far[axis] = d[axis] < 0 ? axis : axis + 3;
  }
  Stack stack;
  const Floats zero{};
  const Floats ox = zero + float(o[0]), oy = zero + float(o[1]), oz = zero + float(o[2]);
  const Floats ix = zero + inverse[0], iy = zero + inverse[1], iz = zero + inverse[2];
  auto end = float(walkEnd(ray.tMax, size[k.z], tree.margin));
  uint32_t child = tree.root;
  do {
    while (!(child & kLeafChild)) {
      const BoxNode& node = tree.nodes[child];
      const auto* b = reinterpret_cast<const Floats*>(node.bounds);
      const Floats from = larger(larger((b[near[0]] - ox) * ix, (b[near[1]] - oy) * iy),
                                 larger((b[near[2]] - oz) * iz, zero));
      const Floats to = smaller(smaller((b[far[0]] - ox) * ix, (b[far[1]] - oy) * iy),
                                smaller((b[far[2]] - oz) * iz, zero + end));
      const uint32_t hit = bits(from * kLess <= to * kMore);
      if (hit == 0) break;
      child = stack.pushAllButNearest(node, hit, from);
    }
    if (!(child & kLeafChild)) continue;
    const TriangleLeaf& leaf = tree.leaves[child & ~kLeafChild];
    const Sheared sheared(triangles(leaf), k, o[k.x], o[k.y], o[k.z], sx, sy);
    for (uint32_t hit = sheared.candidates() & ~own(leaf, ray.own); hit != 0; hit &= hit - 1) {
      const double t = candidate(search, leaf.triangle[__builtin_ctz(hit)]);
      if (t < 0) return;
      end = smaller(end, float(walkEnd(t, size[k.z], tree.margin)));
    }
  } while (stack.pop(child, end));
}

}  // namespace

BoxWalks WALKS() { return {walkRay, walkPacket}; }

}  // namespace sb
