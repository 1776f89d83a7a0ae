// Ways by which host data reaches a buffer: at once, outside frames, or in order with the commands
// of a frame.
#pragma once

#include <functional>
#include <span>

#include "backends/rhi/device.h"

namespace sb {

/// Writes bytes into a buffer from a byte on; none of them, nothing.
using BufferWrite = std::function<void(rhi::BufferId, uint64_t, std::span<const std::byte>)>;

/// Blocking; between frames.
inline BufferWrite uploadsTo(rhi::Device& device) {
  return [&device](rhi::BufferId buffer, uint64_t at, std::span<const std::byte> bytes) {
    device.upload(buffer, at, bytes);
  };
}

/// Within a frame, between passes.
inline BufferWrite writesTo(rhi::CommandList& commands) {
  return [&commands](rhi::BufferId buffer, uint64_t at, std::span<const std::byte> bytes) {
    commands.write(buffer, at, bytes);
  };
}

}  // namespace sb
