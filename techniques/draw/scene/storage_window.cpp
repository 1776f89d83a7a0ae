#include "techniques/draw/scene/storage_window.h"

#include <algorithm>
#include <cassert>

#include "backends/rhi/error.h"
#include "backends/rhi/memory_limit.h"

namespace sb {

StorageWindow storageWindow(const rhi::Limits& limits, uint32_t slot, rhi::BufferId buffer,
                            uint64_t offset, uint64_t size) {
  assert(offset % 4 == 0 && size % 4 == 0);
  const uint64_t start = offset - offset % limits.storageAlignment;
  const uint64_t bytes = std::max<uint64_t>(4, offset - start + size);
  if (bytes > limits.maxStorageRange)
    throw rhi::Error("storage window", rhi::kTooLarge,
                     std::to_string(bytes) + " bytes, expected at most " +
                         std::to_string(limits.maxStorageRange) + " bound at once");
  return {rhi::storageAt(slot, buffer, start, bytes), uint32_t((offset - start) / 4)};
}

}  // namespace sb
