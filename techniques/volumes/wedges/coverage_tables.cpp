#include "techniques/volumes/wedges/coverage_tables.h"

#include <glm/gtc/packing.hpp>

#include "shaders/common/shared_coverage.h"

namespace sb {
namespace {

rhi::Texture table(rhi::Device& device, uint32_t size, bool oneSide) {
  using U = rhi::TextureUse;
  rhi::Texture texture = device.createTexture({.label = "coverage table",
                                               .kind = rhi::TextureKind::Tex3D,
                                               .format = rhi::Format::R16Float,
                                               .width = size,
                                               .height = size,
                                               .depth = size,
                                               .use = U::Sampled | U::CopyTarget});
  const auto at = [&](uint32_t node) { return float(node) / float(size - 1); };
  std::vector<float> parts(size_t(size) * size);  // by end, then distance
  for (size_t i = 0; i < parts.size(); ++i)
    parts[i] = gpu::discPart(at(uint32_t(i % size)), at(uint32_t(i / size)));
  std::vector<uint16_t> slice(parts.size());
  for (uint32_t z = 0; z < size; ++z) {
    for (uint32_t y = 0; y < size; ++y)
      for (uint32_t x = 0; x < size; ++x) {
        const float a = parts[size_t(y) * size + x], b = parts[size_t(z) * size + x];
        slice[size_t(y) * size + x] = glm::packHalf1x16(oneSide ? std::abs(a - b) : a + b);
      }
    device.upload(texture, {.layer = z}, std::as_bytes(std::span(slice)));
  }
  return texture;
}

}  // namespace

CoverageTables coverageTables(rhi::Device& device, uint32_t size) {
  return {.oneSide = table(device, size, true),
          .bothSides = table(device, size, false),
          .sampler = device.createSampler({.label = "coverage table sampler",
                                           .filter = rhi::Filter::Linear,
                                           .addressU = rhi::AddressMode::ClampToEdge,
                                           .addressV = rhi::AddressMode::ClampToEdge,
                                           .addressW = rhi::AddressMode::ClampToEdge})};
}

}  // namespace sb
