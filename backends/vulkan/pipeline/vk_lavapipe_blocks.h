// What Mesa's software Vulkan (lavapipe) needs of shaders.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backends/rhi/types.h"

namespace vulkan {

/// The module with each uniform block turned into an array of one, indexed by bits that are always 0.
/// Takes and returns SPIR-V; the values that a shader computes are the same.
///
/// Mesa compiles values of uniform blocks that decide branches into shaders. Version 22.3 compiles
/// them again, and keeps all results, whenever a pipeline is bound (80 ms and 2 MB a frame), and
/// writes past a table for blocks after the third. It leaves blocks alone whose index it does not
/// know.
std::vector<uint32_t> indexUniformBlocks(std::span<const uint32_t> spirv, rhi::ShaderStage stage);

}  // namespace vulkan
