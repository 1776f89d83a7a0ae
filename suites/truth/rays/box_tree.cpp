#include "suites/truth/rays/box_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace sb {
namespace {

/// As Embree makes them; leaves have no children.
struct Built {
  uint32_t children = 0;
};
struct BuiltLeaf : Built {
  uint32_t triangles = 0;
  uint32_t triangle[kLeafTriangles];
};
struct BuiltNode : Built {
  RTCBounds bounds[kBoxes];
  const Built* child[kBoxes];
};

float roundedDown(double v) { return std::nextafter(float(v), -HUGE_VALF); }
float roundedUp(double v) { return std::nextafter(float(v), HUGE_VALF); }

RTCBuildPrimitive boxOf(const TruthTriangle& triangle, uint32_t number, double margin) {
  const auto& c = triangle.corners;
  const glm::dvec3 low = glm::min(glm::min(c[0], c[1]), c[2]) - margin;
  const glm::dvec3 high = glm::max(glm::max(c[0], c[1]), c[2]) + margin;
  return {.lower_x = roundedDown(low.x),
          .lower_y = roundedDown(low.y),
          .lower_z = roundedDown(low.z),
          .geomID = 0,
          .upper_x = roundedUp(high.x),
          .upper_y = roundedUp(high.y),
          .upper_z = roundedUp(high.z),
          .primID = number};
}

// Nodes and leaves are handed through Embree as what they have in common.
void* makeNode(RTCThreadLocalAllocator allocator, unsigned children, void*) {
  void* place = rtcThreadLocalAlloc(allocator, sizeof(BuiltNode), alignof(BuiltNode));
  Built* node = new (place) BuiltNode;
  node->children = children;
  return node;
}

BuiltNode& nodeAt(void* node) { return *static_cast<BuiltNode*>(static_cast<Built*>(node)); }

void setChildren(void* node, void** children, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i)
    nodeAt(node).child[i] = static_cast<const Built*>(children[i]);
}

void setBounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
  for (unsigned i = 0; i < count; ++i) nodeAt(node).bounds[i] = *bounds[i];
}

void* makeLeaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, size_t count,
               void*) {
  void* place = rtcThreadLocalAlloc(allocator, sizeof(BuiltLeaf), alignof(BuiltLeaf));
  auto* leaf = new (place) BuiltLeaf;
  leaf->triangles = uint32_t(count);
  for (size_t i = 0; i < count; ++i) leaf->triangle[i] = primitives[i].primID;
  return static_cast<Built*>(leaf);
}

/// What Embree made, until it is laid out.
struct Building {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCBVH bvh = device ? rtcNewBVH(device) : nullptr;

  const Built* build(std::vector<RTCBuildPrimitive>& boxes) const {
    RTCBuildArguments args = rtcDefaultBuildArguments();
    args.maxBranchingFactor = kBoxes;
    args.maxDepth = kTreeDepth;
    args.sahBlockSize = kLeafTriangles;
    args.maxLeafSize = kLeafTriangles;
    args.bvh = bvh;
    args.primitives = boxes.data();
    args.primitiveCount = args.primitiveArrayCapacity = boxes.size();
    args.createNode = makeNode;
    args.setNodeChildren = setChildren;
    args.setNodeBounds = setBounds;
    args.createLeaf = makeLeaf;
    const auto* root = bvh ? static_cast<const Built*>(rtcBuildBVH(&args)) : nullptr;
    if (root) return root;
    throw std::runtime_error("Embree: no tree: error " +
                             std::to_string(int(rtcGetDeviceError(device))));
  }
  ~Building() {
    if (bvh) rtcReleaseBVH(bvh);
    if (device) rtcReleaseDevice(device);
  }
};

}  // namespace

// Rays in floats are off by half an ulp of the origin, and of the direction over twice the extent:
// 2^-22 of the extent; boxes are wider by four times that.
BoxTree::BoxTree(const std::vector<TruthTriangle>& triangles, double extent,
                 const std::vector<float>& clear)
    : m_margin(extent * 0x1p-20) {
  if (triangles.empty()) return;
  std::vector<RTCBuildPrimitive> boxes;
  boxes.reserve(triangles.size());
  for (uint32_t i = 0; i < triangles.size(); ++i) boxes.push_back(boxOf(triangles[i], i, m_margin));
  const Building building;
  m_leaves.reserve(triangles.size() / 2 +
                   1);  // hardly ever more, and what is not used costs nothing
  const auto layOut = [&](const auto& self, const Built& any) -> uint32_t {
    if (any.children == 0) {
      const auto& built = static_cast<const BuiltLeaf&>(any);
      const auto index = uint32_t(m_leaves.size());
      TriangleLeaf& leaf = m_leaves.emplace_back();
      for (uint32_t t = 0; t < kLeafTriangles; ++t) {
        const bool present = t < built.triangles;
        leaf.triangle[t] = present ? built.triangle[t] : kNoTriangle;
        leaf.clear[t] = present ? clear[leaf.triangle[t]] : HUGE_VALF;
        for (int c = 0; c < 3; ++c)
          for (int axis = 0; axis < 3; ++axis)
            leaf.corner[c][axis][t] = present ? triangles[leaf.triangle[t]].corners[size_t(c)][axis]
                                              : std::numeric_limits<double>::quiet_NaN();
      }
      return kLeafChild | index;
    }
    const auto& built = static_cast<const BuiltNode&>(any);
    const auto index = uint32_t(m_nodes.size());
    m_nodes.emplace_back();
    for (uint32_t i = 0; i < kBoxes; ++i) {
      const bool present = i < built.children;
      const RTCBounds none{HUGE_VALF,  HUGE_VALF,  HUGE_VALF,  0,
                           -HUGE_VALF, -HUGE_VALF, -HUGE_VALF, 0};
      const RTCBounds& b = present ? built.bounds[i] : none;
      const float bounds[6] = {b.lower_x, b.lower_y, b.lower_z, b.upper_x, b.upper_y, b.upper_z};
      for (uint32_t k = 0; k < 6; ++k) m_nodes[index].bounds[k][i] = bounds[k];
      const uint32_t child = present ? self(self, *built.child[i]) : 0;
      m_nodes[index].child[i] = child;
    }
    return index;
  };
  m_root = layOut(layOut, *building.build(boxes));
}

}  // namespace sb
