// The visibility buffer of a cell (decision D10): per light, the RGB fraction of light that the
// technique says arrives at the first four layers of surfaces and at the first opaque one. Never
// part of a timed frame.
#pragma once

#include "techniques/render/camera_pass.h"

namespace sb {

/// One layer for one light: width * height * 4 floats, row 0 = bottom row of the picture (clip
/// y = -1); alpha 1 where a surface is, else all 0.
using VisibilityImage = std::vector<float>;

class VisibilityBuffer {
 public:
  static constexpr uint32_t kLayers = 4;

  /// `technique` may be null. One that makes maps between translucent surfaces makes them again.
  VisibilityBuffer(const Context& context, const CameraPass& camera, ShadowTechnique* technique,
                   FrameQueries& queries);

  /// Records and reads back. Call between frames. Element 0 is the first opaque surface, 1..kLayers
  /// the layers from the eye.
  std::vector<VisibilityImage> render(ViewLight light);

 private:
  VisibilityImage renderLayer(ViewLight light, uint32_t layer);
  /// What a layer is found by: the depths of the opaque surface and of the layer before.
  std::vector<rhi::ResourceUse> depthReads(uint32_t layer) const;
  void recordLayer(Frame& frame, uint32_t layer, DrawList& draws);
  void recordDepth(Frame& frame, uint32_t layer, DrawList& draws);
  void recordAnswer(Frame& frame, uint32_t layer, DrawList& draws);

  const Context m_context;
  const CameraPass& m_camera;
  ShadowTechnique* m_technique;
  FrameQueries& m_queries;
  rhi::Texture m_target, m_opaqueDepth, m_layerDepth[2];
  rhi::Texture m_receiverDepth;  ///< only where the technique answers by layers
  rhi::Buffer m_pass;
  rhi::Sampler m_sampler;
  struct Pipelines {
    rhi::PipelineId singleSided, doubleSided, translucent;
  };
  Pipelines pipelines(rhi::GraphicsPipelineDesc opaque,
                      rhi::GraphicsPipelineDesc translucent) const;
  Pipelines m_answer, m_depthOnly;
};

}  // namespace sb
