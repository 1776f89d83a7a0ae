// Which rays of a packet walk together, and their numbers as walks take them, side by side.
#pragma once

#include "suites/truth/rays/box_walk_lines.h"

namespace sb {
namespace {

[[gnu::always_inline]] inline Doubles& half(double* values, uint32_t h) {
  return reinterpret_cast<Doubles*>(values)[h];
}
[[gnu::always_inline]] inline const Doubles& half(const double* values, uint32_t h) {
  return reinterpret_cast<const Doubles*>(values)[h];
}

constexpr uint32_t kAll = (1u << kPacket) - 1;

/// Rays of a packet whose directions have the same signs and the same largest component. Places
/// without one repeat the first.
struct Bundle {
  Axes k;
  bool negative[3];
  /// As ShearedRay.
  alignas(32) double ox[kPacket], oy[kPacket], oz[kPacket], sx[kPacket], sy[kPacket];
  alignas(32) double length[kPacket];  ///< the largest component
  alignas(32) double span[kPacket];    ///< Sheared::stopping
  /// Distances count in the largest component.
  alignas(32) float origin[3][kPacket], inverse[3][kPacket];
  alignas(32) float ends[kPacket];  ///< negative: no ray there, or it ended
  uint32_t own;                     ///< the triangle that none is asked for

  Bundle(const WalkPacket& packet, uint32_t rays, int largest, double margin) : k(largest) {
    const auto first = uint32_t(__builtin_ctz(rays));
    for (int axis = 0; axis < 3; ++axis) negative[axis] = packet.direction[axis][first] < 0;
    for (uint32_t h = 0; h < 2; ++h) {
      const uint32_t places = rays >> (h * kLanes);
      const Longs here = lanes(places);
      const auto of = [&](const double* values) __attribute__((always_inline)) {
        if (rays == kAll) return half(values, h);
        return here ? half(values, h) : Doubles{} + values[first];
      };
      const Doubles dz = of(packet.direction[k.z]), tMax = of(packet.tMax);
      half(sx, h) = of(packet.direction[k.x]) / dz;
      half(sy, h) = of(packet.direction[k.y]) / dz;
      half(ox, h) = of(packet.origin[k.x]);
      half(oy, h) = of(packet.origin[k.y]);
      half(oz, h) = of(packet.origin[k.z]);
      half(length, h) = absolute(dz);
      // A way that is infinite is far longer than any that ends.
      half(span, h) = lanes(packet.unasked >> (h * kLanes))
                          ? dz * smaller(tMax, Doubles{} + 0x1p500)
                          : Doubles{};
      const auto floats = [h](float* values) -> FourFloats& {
        return reinterpret_cast<FourFloats*>(values)[h];
      };
      const FourFloats one = FourFloats{} + 1;
      floats(inverse[k.x]) = inverseOf(toFloats(half(sx, h)), negative[k.x]);
      floats(inverse[k.y]) = inverseOf(toFloats(half(sy, h)), negative[k.y]);
      floats(inverse[k.z]) = negative[k.z] ? -one : one;
      floats(origin[k.x]) = toFloats(half(ox, h));
      floats(origin[k.y]) = toFloats(half(oy, h));
      floats(origin[k.z]) = toFloats(half(oz, h));
      floats(ends) = toFloats(here ? walkEnd(tMax, half(length, h), margin) : Doubles{} - 1);
    }
    own = packet.own[first];
    for (uint32_t left = rays; left != 0; left &= left - 1)
      if (packet.own[__builtin_ctz(left)] != own) own = kNoTriangle;
  }
};

/// Signs and largest component of each direction: what rays that walk together share. The largest
/// component is that of ShearedRay; none of a ray that has no direction.
struct Classes {
  alignas(32) int64_t of[kPacket];
  static constexpr int64_t kLargest = 3;  ///< bits

  explicit Classes(const WalkPacket& packet) {
    for (uint32_t h = 0; h < 2; ++h) {
      const Doubles d[3] = {half(packet.direction[0], h), half(packet.direction[1], h),
                            half(packet.direction[2], h)};
      const Longs largest = largestOf(absolute(d[0]), absolute(d[1]), absolute(d[2]), Longs{});
      *reinterpret_cast<Longs*>(of + h * kLanes) =
          largest | ((d[0] < 0) & 4) | ((d[1] < 0) & 8) | ((d[2] < 0) & 16);
    }
  }
  uint32_t like(uint32_t ray) const {
    uint32_t rays = 0;
    for (uint32_t h = 0; h < 2; ++h)
      rays |= bits(*reinterpret_cast<const Longs*>(of + h * kLanes) == of[ray]) << (h * kLanes);
    return rays;
  }
};

}  // namespace
}  // namespace sb
