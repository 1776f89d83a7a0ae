#include "techniques/volumes/shadow_mask.h"

#include <array>

#include "shaders/common/shared_slots.h"

namespace sb {
namespace {

rhi::Format formatOf(MaskKind kind, uint32_t count) {
  using F = rhi::Format;
  static constexpr std::array<F, 3> kBinary = {F::R8Unorm, F::RG8Unorm, F::RGBA8Unorm};
  static constexpr std::array<F, 3> kShare = {F::R16Float, F::RG16Float, F::RGBA16Float};
  return (kind == MaskKind::Binary ? kBinary : kShare)[std::min<size_t>(count - 1, 2)];
}

}  // namespace

ShadowMask::ShadowMask(const Context& context, MaskKind kind, uint32_t slots, uint32_t inView)
    : m_count(slots), m_format(formatOf(kind, slots)) {
  using U = rhi::TextureUse;
  const auto [width, height] = context.view.size();
  const uint32_t layers = (slots + kChannels - 1) / kChannels;
  m_mask = context.device.createTexture({.label = "shadow mask",
                                         .kind = rhi::TextureKind::Tex2DArray,
                                         .format = m_format,
                                         .width = width,
                                         .height = height,
                                         .layers = layers,
                                         .use = U::ColorTarget | U::Sampled | U::CopyTarget});
  // Steps in which nothing casts write none of it.
  const size_t texels = size_t(width) * height;
  const rhi::FormatInfo& info = rhi::formatInfo(m_format);
  const std::vector<uint8_t> lit8(texels * kChannels, 0xFF);
  const std::vector<uint16_t> lit16(texels * kChannels, 0x3C00);
  const auto lit =
      kind == MaskKind::Binary ? std::as_bytes(std::span(lit8)) : std::as_bytes(std::span(lit16));
  for (uint32_t layer = 0; layer < layers && !context.view.stands(); ++layer)
    context.device.upload(m_mask, {.layer = layer}, lit.first(texels * info.texelBytes));
  m_slots =
      context.device.createBuffer({.label = "shadow mask slots",
                                   .size = std::max<uint64_t>(16, 4 * uint64_t(inView)),
                                   .use = rhi::BufferUse::Storage | rhi::BufferUse::CopyTarget});
  m_sampler = context.device.createSampler(
      {.label = "shadow mask sampler", .filter = rhi::Filter::Nearest});
}

void ShadowMask::assign(const std::vector<uint32_t>& slots, const Write& write) const {
  if (!slots.empty()) write(m_slots, std::as_bytes(std::span(slots)));
}

rhi::ColorAttachment ShadowMask::attachment(uint32_t slot) const {
  return {.view = {.texture = m_mask, .baseLayer = slot / kChannels, .layerCount = 1},
          .load = slot % kChannels == 0 ? rhi::LoadOp::Clear : rhi::LoadOp::Load,
          .clear = {1, 1, 1, 1}};
}

VisibilityInputs ShadowMask::inputs() const {
  return {.bindings = {rhi::textureAt(TEXTURE_TECHNIQUE, m_mask, m_sampler),
                       rhi::storageAt(STORAGE_TECHNIQUE, m_slots)},
          .reads = {rhi::use(m_mask.id(), rhi::Access::Sampled)}};
}

}  // namespace sb
