// The picture: opaque surfaces shaded through the technique's visibility, then the transparency
// technique over them. Colour is linear RGBA16F, depth D32F.
#pragma once

#include "shaders/common/shared_slots.h"
#include "techniques/draw/draw_list.h"
#include "techniques/render/registry.h"

namespace sb {

class CameraPass {
 public:
  static constexpr rhi::Format kColorFormat = rhi::Format::RGBA16Float;
  static constexpr rhi::Format kDepthFormat = rhi::Format::D32Float;

  /// `folder`: of the shaders that answer lightVisibility. `transparency` may be null when the plan
  /// has no Effect::CameraTransparency.
  CameraPass(const Context& context, std::string folder, VisibilityInputs inputs,
             const TransparencyEntry* transparency);

  /// Within a frame, after the scene view has moved.
  void cameraMoved(Frame& frame);
  void recordOpaque(Frame& frame);
  void recordTranslucent(Frame& frame);
  /// Some of them, after all behind these.
  void recordTranslucent(Frame& frame, std::span<const uint32_t> part);
  /// What the transparency technique has to say of the last frame. Call between frames.
  std::vector<std::string> warnings();

  rhi::TextureId color() const { return m_color; }
  rhi::TextureId depth() const { return m_depth; }
  const std::string& folder() const { return m_folder; }
  const VisibilityInputs& inputs() const { return m_inputs; }

  // For transparency techniques.

  /// Pipeline of translucent surfaces with `emit` of the technique's folder: reads depth LEQUAL,
  /// writes none, one colour target without blending. Change what differs, then get it.
  rhi::GraphicsPipelineDesc translucentPipeline(const std::string& transparencyFolder) const;
  /// The same surfaces through a fragment shader that does not shade (depths, opacities): neither
  /// targets nor depth yet.
  rhi::GraphicsPipelineDesc unshadedPipeline(const std::string& fragment) const;
  /// A full-screen draw that adds colour to the picture times a transmittance: the shader's output
  /// is (premultiplied colour of all layers, their transmittance T), the picture becomes
  /// colour + T picture.
  rhi::GraphicsPipelineDesc compositePipeline(const std::string& fragment) const;
  /// The same with a transmittance per channel in a second source of index 1. Needs
  /// Feature::DualSourceBlend.
  rhi::GraphicsPipelineDesc colouredCompositePipeline(const std::string& fragment) const;
  /// A pass over the opaque picture: colour loaded, depth read only, visibility declared.
  /// Where surfaces lie in one plane with opaque ones, depth is not attached but sampled: the shader
  /// tests it (common/opaque_test.glsl, folders `.../coplanar`).
  void translucentPass(Frame& frame, const std::string& label,
                       const std::function<void(rhi::CommandList&)>& body);
  /// A pass with attachments of the technique's own that draws surfaces; what visibility reads is
  /// declared beside `desc.reads`.
  void surfacePass(Frame& frame, rhi::PassDesc desc,
                   const std::function<void(rhi::CommandList&)>& body);
  /// A pass over the opaque picture for draws of `compositePipeline`: colour loaded, no depth.
  void compositePass(Frame& frame, const std::string& label,
                     std::span<const rhi::ResourceUse> reads,
                     const std::function<void(rhi::CommandList&)>& body);
  const SceneView& view() const { return m_context.view; }
  /// Instances that the camera sees through now, in scene order.
  std::span<const uint32_t> translucent() const { return view().effects().visibleTranslucent; }
  /// Of draws in `translucentPass`.
  DrawList& drawList() { return coplanar() ? m_translucentDraws : m_drawList; }
  /// Surfaces of the scene lie over others in one plane.
  bool coplanar() const { return !view().gpu().coplanar().empty(); }
  /// The opaque depth as shaders sample it; only where surfaces are coplanar.
  rhi::Binding opaqueDepth() const {
    return rhi::textureAt(TEXTURE_TRANSPARENCY, m_depth, m_depthSampler);
  }
  /// A list of its own, with bindings beside those of visibility.
  DrawList drawListWith(std::span<const rhi::Binding> extra) const;

  // For whatever draws the same surfaces for another purpose.

  /// A pipeline of surfaces that asks the technique: `fragment` of its folder, writing depth.
  rhi::GraphicsPipelineDesc surfacePipeline(const std::string& label, const std::string& fragment,
                                            bool masked) const;
  /// The opaque surfaces that the camera sees, by pipelines and with bindings that are not its own.
  void drawOpaque(rhi::CommandList& commands, DrawList& draws, rhi::PipelineId singleSided,
                  rhi::PipelineId doubleSided) const;

 private:
  /// Opaque instances that share a pipeline. Single-sided materials show no back faces (glTF); to
  /// light they are two-sided all the same.
  struct Bucket {
    bool masked = false;
    bool doubleSided = false;
    std::vector<uint32_t> instances;
    rhi::PipelineId pipeline;
  };
  void fillBuckets();

  const Context m_context;
  std::string m_folder;
  VisibilityInputs m_inputs;
  rhi::Texture m_color, m_depth;
  rhi::Sampler m_depthSampler;
  std::vector<Bucket> m_buckets;
  std::map<std::pair<bool, bool>, rhi::PipelineId> m_opaque;  ///< by masked and double-sided
  rhi::Buffer m_noOrder;
  DrawList m_drawList, m_translucentDraws;
  std::unique_ptr<TransparencyTechnique> m_transparency;
};

/// Draws common/fullscreen.vert.
inline void drawFullscreen(rhi::CommandList& commands, rhi::PipelineId pipeline,
                           std::span<const rhi::Binding> bindings) {
  commands.draw({.pipeline = pipeline, .bindings = bindings}, {.vertexCount = 3});
}

}  // namespace sb
