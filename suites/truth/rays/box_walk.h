// A ray's walk through a tree of boxes (box_tree.h). Kernels only sort out what cannot be met:
// boxes with room for rounding, triangles by the very arithmetic of suites/truth/rays/watertight.h.
// Which kernel walks, and in which order, changes no answer. No headers with code in them:
// box_walk_avx2.cpp is compiled for a newer CPU, and what it shares with others the linker might
// take from it.
#pragma once

#include <cstdint>

namespace sb {

constexpr uint32_t kBoxes = 8;          ///< children of a node
constexpr uint32_t kLeafTriangles = 4;  ///< of a leaf
constexpr uint32_t kLeafChild = 1u << 31;
constexpr uint32_t kTreeDepth = 40;
constexpr uint32_t kPacket = 8;  ///< rays that walk together

struct alignas(64) BoxNode {
  float bounds[6]
              [kBoxes];    ///< least x, y, z, greatest x, y, z; nothing meets a place without child
  uint32_t child[kBoxes];  ///< number of a node, or kLeafChild | number of a leaf
};

struct alignas(64) TriangleLeaf {
  double corner[3][3][kLeafTriangles];  ///< [corner][axis][triangle]; NaN in places without one
  uint32_t triangle[kLeafTriangles];
};

struct BoxTreeView {
  const BoxNode* nodes;
  const TriangleLeaf* leaves;
  uint32_t root;  ///< as BoxNode::child
};

/// A ray as triangles meet it.
struct WalkLine {
  int kx, ky, kz;  ///< as ShearedRay
  double ox, oy, oz, sx, sy;
  uint32_t own;  ///< the triangle that is not asked for
};

/// Distances along it count in its largest component.
struct WalkRay {
  float origin[3];
  float inverse[3];  ///< of the direction, finite
  float end;
  WalkLine line;
};

/// Rays whose directions have the same signs, side by side. In places without a ray: `end` is
/// negative, origin and inverse are those of another.
struct alignas(32) WalkPacket {
  float origin[3][kPacket];
  float inverse[3][kPacket];
  float end[kPacket];  ///< negative: no ray there, or it ended
  WalkLine lines[kPacket];
};

/// Asked for triangles that the ray's line meets: how far to walk on; negative ends the walk.
using Candidate = float (*)(void* search, uint32_t triangle, float end);
/// The same for a ray of a packet.
using PacketCandidate = float (*)(void* search, uint32_t ray, uint32_t triangle, float end);

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
