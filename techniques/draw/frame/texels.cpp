#include "techniques/draw/frame/texels.h"

#include <cstdint>
#include <glm/gtc/packing.hpp>

namespace sb {

std::vector<float> halfToFloat(std::span<const std::byte> texels) {
  std::vector<float> out(texels.size() / 2);
  const auto* half = reinterpret_cast<const uint16_t*>(texels.data());
  for (size_t i = 0; i < out.size(); ++i) out[i] = glm::unpackHalf1x16(half[i]);
  return out;
}

}  // namespace sb
