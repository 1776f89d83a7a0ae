// Colour targets as large as the picture, and the blending of colours per channel into them.
#pragma once

#include "techniques/render/technique.h"

namespace sb {

/// Light adds up, in alpha too.
inline constexpr rhi::BlendState kBlendAdd = {
    .enabled = true, .dstColor = rhi::BlendFactor::One, .dstAlpha = rhi::BlendFactor::One};
/// What is there, less what is drawn, in alpha too.
inline constexpr rhi::BlendState kBlendTake = {.enabled = true,
                                               .dstColor = rhi::BlendFactor::One,
                                               .colorOp = rhi::BlendOp::ReverseSubtract,
                                               .dstAlpha = rhi::BlendFactor::One,
                                               .alphaOp = rhi::BlendOp::ReverseSubtract};
/// Weights multiply; alpha stays.
inline constexpr rhi::BlendState kBlendMultiply = {.enabled = true,
                                                   .srcColor = rhi::BlendFactor::Zero,
                                                   .dstColor = rhi::BlendFactor::SrcColor,
                                                   .srcAlpha = rhi::BlendFactor::Zero,
                                                   .dstAlpha = rhi::BlendFactor::One};

/// A target of the picture's size; if not told otherwise, of colours that later passes sample.
inline rhi::TextureDesc screenTarget(const Context& context, const char* label, rhi::Format format,
                                     rhi::TextureUse use = rhi::TextureUse::ColorTarget |
                                                           rhi::TextureUse::Sampled) {
  const auto [width, height] = context.view.size();
  return {.label = label, .format = format, .width = width, .height = height, .use = use};
}

}  // namespace sb
