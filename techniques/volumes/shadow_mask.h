// Shares of lights that arrive at one layer of receivers, a texture of the picture's size with a
// channel a light (shaders/common/shadow_mask.glsl): what techniques in screen space leave behind.
#pragma once

#include "techniques/render/technique.h"

namespace sb {

enum class MaskKind : uint8_t {
  Binary,  ///< R8, in the dark or lit
  Share,   ///< R16F: steps of 5e-4 at most
};

class ShadowMask {
 public:
  static constexpr uint32_t kChannels = 4;  ///< of a layer

  /// `slots`: lights that need a channel, at most, at least one; `inView`: lights that touch the
  /// view, at most.
  ShadowMask(const Context& context, MaskKind kind, uint32_t slots, uint32_t inView);

  /// Which slot each light in view has; NO_SHADOW: none, it is lit.
  using Write = std::function<void(rhi::BufferId, std::span<const std::byte>)>;
  void assign(const std::vector<uint32_t>& slots, const Write& write) const;

  /// Channels that pipelines are made for.
  uint32_t channels() const { return std::min(m_count, kChannels); }
  /// Of pipelines that write one channel.
  rhi::ColorTargetState target(uint32_t channel) const {
    return {.format = m_format, .writeMask = uint8_t(1u << channel)};
  }
  /// For a pass that fills a slot; before the first of a layer all channels are lit.
  rhi::ColorAttachment attachment(uint32_t slot) const;
  /// For shaders that include common/shadow_mask.glsl.
  VisibilityInputs inputs() const;

 private:
  uint32_t m_count;
  rhi::Format m_format;
  rhi::Texture m_mask;
  rhi::Buffer m_slots;
  rhi::Sampler m_sampler;
};

}  // namespace sb
