// A ray's walk through a tree of boxes (box_tree.h). Kernels only sort out what cannot be met:
// boxes with room for rounding, triangles by the very arithmetic of suites/truth/rays/watertight.h.
// Which kernel walks, and in which order, changes no answer. They include
// no code that is not local to their files: box_walk_avx2.cpp is compiled for a newer CPU, and what
// it shares with others the linker might take from it.
#pragma once

#include <cstdint>

namespace sb {

constexpr uint32_t kBoxes = 8;          ///< children of a node
constexpr uint32_t kLeafTriangles = 4;  ///< of a leaf
constexpr uint32_t kLeafChild = 1u << 31;
constexpr uint32_t kNoTriangle = ~0u;  ///< in places of a leaf without one
constexpr uint32_t kTreeDepth = 40;
constexpr uint32_t kPacket = 8;  ///< rays that walk together

struct alignas(64) BoxNode {
  float bounds[6]
              [kBoxes];    ///< least x, y, z, greatest x, y, z; nothing meets a place without child
  uint32_t child[kBoxes];  ///< number of a node, or kLeafChild | number of a leaf
};

struct alignas(64) TriangleLeaf {
  double corner[3][3][kLeafTriangles];  ///< [corner][axis][triangle]; NaN in places without one
  /// A ray that is stopped by whatever blocks it is stopped for sure if its beginning and its end
  /// lie farther from the triangle's plane than so many heights: these times four times the
  /// triangle's area, and what doubles round off.
  float clear[kLeafTriangles];
  uint32_t triangle[kLeafTriangles];
};

struct BoxTreeView {
  const BoxNode* nodes;
  const TriangleLeaf* leaves;
  uint32_t root;  ///< as BoxNode::child
  double margin;  ///< by which boxes are wider than what they hold
};

/// A ray from its origin to `tMax` times its direction.
struct WalkRay {
  double origin[3], direction[3];
  double tMax;   ///< may be infinite
  uint32_t own;  ///< the triangle that is not asked for
};

/// Rays side by side. Those walk together whose directions, none of which is zero, have the same
/// signs and the same largest component.
struct alignas(64) WalkPacket {
  double origin[3][kPacket], direction[3][kPacket];
  double tMax[kPacket];
  uint32_t own[kPacket];
  uint32_t rays;     ///< a bit for each
  uint32_t unasked;  ///< those that a triangle may stop unasked (TriangleLeaf::clear)
  uint32_t stopped;  ///< those that one did: found by the walk
};

/// Asked for triangles that the ray's line meets: up to which t to walk on; negative ends the walk.
using Candidate = double (*)(void* search, uint32_t triangle);
/// The same for a ray of a packet.
using PacketCandidate = double (*)(void* search, uint32_t ray, uint32_t triangle);

/// The walks compiled for one set of instructions.
struct BoxWalks {
  void (*ray)(const BoxTreeView& tree, const WalkRay& ray, Candidate candidate, void* search);
  void (*packet)(const BoxTreeView& tree, WalkPacket& packet, PacketCandidate candidate,
                 void* search);
};
BoxWalks baselineWalks();
/// Only where the CPU has AVX2; no fused multiplication, which would round otherwise.
BoxWalks avx2Walks();
bool hasAvx2();
/// The fastest that this CPU has.
const BoxWalks& bestWalks();

}  // namespace sb
