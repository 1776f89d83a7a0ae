// Whether what is asked for fits the device, before anything is allocated: the largest texture, and
// the sum of all that is alive against its memory. Software devices share the machine's memory, and
// drivers touch pages late: what was promised to all of them counts, against what was free when the
// first one asked and against what is free now, so that no allocation ends in the kernel's
// out-of-memory killer.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "backends/rhi/desc.h"
#include "backends/rhi/device_info.h"
#include "backends/rhi/error.h"

namespace rhi {

/// Error::code of refusals from here.
inline constexpr const char* kTooLarge = "TOO_LARGE";

/// The device is too small for what was asked for, as it or its driver says: an expected absence,
/// which shows only while creating.
bool isTooLarge(const Error& error);
/// The same in words for people.
std::string whyTooLarge(const Error& error);

/// Throws Error with kTooLarge: which allocation, its bytes, and the limit. `live`: bytes that the
/// device holds.
void requireFit(const DeviceInfo& device, uint64_t live, const TextureDesc& desc);
void requireFit(const DeviceInfo& device, uint64_t live, const BufferDesc& desc);

/// Throws Error with kTooLarge when `bytes` of a buffer are more than a shader of the device
/// reaches through one binding.
void requireStorageRange(const Limits& limits, const std::string& label, uint64_t bytes);

/// How the words of whyTooLarge() begin.
inline constexpr const char* kTooLargeWords = "too large for this device: ";

/// Memory of this machine, or of the container that it is; bytes.
uint64_t machineMemory();
/// What software devices may hold, all together, however much is free.
void limitHostMemory(uint64_t bytes);
uint64_t hostMemoryLimit();

/// Bytes that software devices hold of the machine's memory, all together.
void bookHostMemory(const DeviceInfo& device, int64_t bytes);
/// Of a machine with so much free memory, whatever is true. Tests only; nothing: as it is.
void pretendFreeMemory(std::optional<uint64_t> bytes);

}  // namespace rhi
