// A shader library as bytes, for embedding in a program.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "backends/rhi/shader.h"

namespace shader {

std::string toBlob(const rhi::ShaderLibrary& library);
/// Adds everything in `blob` to `library`. Throws rhi::Error if the blob is cut short.
void fromBlob(std::span<const std::byte> blob, rhi::ShaderLibrary& library);

}  // namespace shader
