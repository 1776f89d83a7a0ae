// Part of a large buffer as a storage binding: devices bind 128 MiB at least, from aligned places.
#pragma once

#include "backends/rhi/device.h"

namespace sb {

struct StorageWindow {
  rhi::Binding binding;
  uint32_t first = 0;  ///< number of the part's first word, counted from the start of the binding
};

/// `slot`: of storage buffers. `offset` (within the buffer) and `size` in bytes,
/// multiples of 4. Throws rhi::Error when
/// the device cannot bind as much at once.
StorageWindow storageWindow(const rhi::Limits& limits, uint32_t slot, rhi::BufferId buffer,
                            uint64_t offset, uint64_t size);

}  // namespace sb
