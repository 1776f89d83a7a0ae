// Colour targets as large as the picture, and the blending of colours per channel into them.
#pragma once

#include "techniques/render/technique.h"

namespace sb {

/// Light adds up, in alpha too.
inline constexpr rhi::BlendState kBlendAdd = {
    .enabled = true, .dstColor = rhi::BlendFactor::One, .dstAlpha = rhi::BlendFactor::One};
/// Weights multiply; alpha stays.
inline constexpr rhi::BlendState kBlendMultiply = {.enabled = true,
                                                   .srcColor = rhi::BlendFactor::Zero,
                                                   .dstColor = rhi::BlendFactor::SrcColor,
                                                   .srcAlpha = rhi::BlendFactor::Zero,
                                                   .dstAlpha = rhi::BlendFactor::One};

/// A target of the picture's size that later passes sample.
inline rhi::Texture screenTarget(const Context& context, const char* label, rhi::Format format) {
  const auto [width, height] = context.view.size();
  return context.device.createTexture(
      {.label = label,
       .format = format,
       .width = width,
       .height = height,
       .use = rhi::TextureUse::ColorTarget | rhi::TextureUse::Sampled});
}

}  // namespace sb
