// A backend without a driver: every feature, contents of buffers and textures in host memory (kept
// for uploads, reads, writes, fills and copies; draws and dispatches change nothing), monotone fake
// timestamps. What was recorded is plain data, for tests of the pass structure of techniques.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "backends/rhi/device.h"

namespace null_backend {

enum class CallKind : uint8_t {
  BeginPass,
  EndPass,
  Draw,
  DrawIndexed,
  DrawIndirect,
  DrawIndexedIndirect,
  Dispatch,
  DispatchIndirect,
  Write,
  Fill,
  Copy,
  Timestamp,
  BeginQuery,
  EndQuery
};
std::string_view callName(CallKind kind);

/// One recorded command. `args` by kind: Draw: vertices, instances, first vertex; DrawIndexed:
/// indices, instances, first index, vertex offset, first instance; indirect: offset, count, stride;
/// Dispatch: x, y, z; DispatchIndirect: offset; Write, Fill, buffer Copy: (target) offset, size;
/// queries: index.
struct Call {
  CallKind kind = CallKind::BeginPass;
  std::string pass;      ///< label of the pass it stands in; empty outside passes
  std::string pipeline;  ///< label, for draws and dispatches
  std::string resource;  ///< label of the buffer, texture or pool, where there is one
  std::vector<uint64_t> args;
  bool operator==(const Call&) const = default;
};

std::unique_ptr<rhi::Backend> makeBackend();

/// Everything recorded on a device of this backend since it was opened or last cleared.
const std::vector<Call>& calls(const rhi::Device& device);
void clearCalls(rhi::Device& device);

}  // namespace null_backend
