// Texels that were read back, as numbers.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sb {

/// RGBA16F texels as floats (exact).
std::vector<float> halfToFloat(std::span<const std::byte> texels);

}  // namespace sb
