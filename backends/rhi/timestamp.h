// Time between two timestamps of a device. Counters are narrow (36 bits on some GPUs, which wrap
// within the hour): a difference is taken modulo their bits, in ticks, before it is scaled.
#pragma once

#include <cstdint>

#include "backends/rhi/device_info.h"

namespace rhi {

/// Nanoseconds from the timestamp `from` to the later `to`, both as Device::readQueries gives them.
/// Right while less than one turn of the counter lies between them; a counter that was reset in
/// between gives nearly a whole turn, which callers know by comparing with wall time.
inline double elapsedNs(const Limits& limits, uint64_t from, uint64_t to) {
  const uint64_t mask =
      limits.timestampBits >= 64 ? UINT64_MAX : (uint64_t(1) << limits.timestampBits) - 1;
  return double((to - from) & mask) * double(limits.timestampPeriodNs);
}

}  // namespace rhi
