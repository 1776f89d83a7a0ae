// The table of formats and the names of features and device types.
#include <cassert>

#include "backends/rhi/device_info.h"
#include "backends/rhi/types.h"

namespace rhi {

const FormatInfo& formatInfo(Format format) {
  using K = FormatKind;
  static constexpr FormatInfo kTable[] = {
      {"undefined", 0, 0, K::Unorm},
      {"R8", 1, 1, K::Unorm}, {"RG8", 2, 2, K::Unorm}, {"RGBA8", 4, 4, K::Unorm},
      {"RGBA8_SRGB", 4, 4, K::Unorm}, {"RGB10A2", 4, 4, K::Unorm},
      {"R16", 2, 1, K::Unorm}, {"RG16", 4, 2, K::Unorm}, {"RGBA16", 8, 4, K::Unorm},
      {"R16F", 2, 1, K::Float}, {"RG16F", 4, 2, K::Float}, {"RGBA16F", 8, 4, K::Float},
      {"R32F", 4, 1, K::Float}, {"RG32F", 8, 2, K::Float}, {"RGBA32F", 16, 4, K::Float},
      {"R8UI", 1, 1, K::Uint}, {"R16UI", 2, 1, K::Uint}, {"RG16UI", 4, 2, K::Uint},
      {"RGBA16UI", 8, 4, K::Uint}, {"R32UI", 4, 1, K::Uint}, {"RG32UI", 8, 2, K::Uint},
      {"RGBA32UI", 16, 4, K::Uint}, {"R32I", 4, 1, K::Sint},
      {"D16", 2, 1, K::Depth, true}, {"D24", 4, 1, K::Depth, true},
      {"D24S8", 4, 1, K::Depth, true, true}, {"D32F", 4, 1, K::Depth, true},
      {"D32FS8", 8, 1, K::Depth, true, true},
  };
  static_assert(std::size(kTable) == size_t(Format::Count));
  assert(format < Format::Count);
  return kTable[size_t(format)];
}

uint32_t hostTexelBytes(Format format, Aspect aspect) {
  if (aspect == Aspect::Stencil) return 1;
  if (format == Format::D32FloatS8) return 4;
  return formatInfo(format).texelBytes;
}

std::string_view featureName(Feature feature) {
  static constexpr std::string_view kNames[] = {
      "depth-clamp", "geometry-shader", "vertex-layer", "sample-rate-shading", "dual-source-blend",
      "independent-blend", "logic-op", "fragment-stores-and-atomics", "pipeline-statistics",
      "precise-occlusion", "multi-draw-indirect", "sampler-anisotropy", "fragment-interlock",
      "conservative-raster", "depth-bounds", "ray-query", "presentation"};
  static_assert(std::size(kNames) == size_t(Feature::Count));
  return kNames[size_t(feature)];
}

std::string_view deviceTypeName(DeviceType type) {
  static constexpr std::string_view kNames[] = {"discrete", "integrated", "virtual", "software",
                                                "other"};
  return kNames[size_t(type)];
}

}  // namespace rhi
