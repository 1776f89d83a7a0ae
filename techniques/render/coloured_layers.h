// Layers with a weight per channel (Effect::ColouredTransparency), composed front to back: their
// light, dimmed by what lies before it, is added up, and the transmittance of all layers so far
// goes from one target to another, since blending has no factor per channel for two targets at
// once. Three targets of half floats; one full-screen pass a layer.
#pragma once

#include "techniques/render/camera_pass.h"

namespace sb {

/// A layer's light, already weighted by its coverage, and its weight of what lies behind: colour 0
/// and weight 1 where there is no layer.
struct ColouredLayer {
  rhi::TextureId light;
  rhi::TextureId behind;
};

class ColouredLayers {
 public:
  ColouredLayers() = default;
  ColouredLayers(const Context& context, const CameraPass& camera);

  /// Slides a layer under those before it.
  void slideUnder(Frame& frame, const ColouredLayer& layer, bool first);
  /// All of them over the picture. `alsoReads` and `body`: what else is drawn in that pass.
  void composite(Frame& frame, CameraPass& camera, std::span<const rhi::ResourceUse> alsoReads = {},
                 const std::function<void(rhi::CommandList&)>& body = {});
  /// One layer over the picture, which holds all that lies behind it.
  void layOver(Frame& frame, CameraPass& camera, const ColouredLayer& layer);

 private:
  void over(Frame& frame, CameraPass& camera, const std::string& label, const ColouredLayer& layer,
            std::span<const rhi::ResourceUse> alsoReads,
            const std::function<void(rhi::CommandList&)>& body);

  rhi::Texture m_color, m_through[2];
  uint32_t m_current = 0;  ///< of m_through
  rhi::Sampler m_sampler;
  rhi::PipelineId m_first, m_under, m_over;
};

}  // namespace sb
