// The picture: opaque surfaces shaded through the technique's visibility, then the transparency
// technique over them. Colour is linear RGBA16F, depth D32F, 1 near .. 0 far.
#pragma once

#include "shaders/common/shared_slots.h"
#include "techniques/draw/draw_list.h"
#include "techniques/render/opaque_surfaces.h"
#include "techniques/render/registry.h"

namespace sb {

/// What shades surfaces.
struct CameraPassDesc {
  std::string folder;                  ///< of the shaders that answer lightVisibility
  VisibilityInputs inputs;             ///< what they read, and what the loop over lights reads
  std::string lightsFolder;            ///< of the loop over lights
  ShadowTechnique* byLayer = nullptr;  ///< the shadow technique, if it answers by layers
  /// Null: the plan has no Effect::CameraTransparency.
  const TransparencyEntry* transparency = nullptr;
};

class CameraPass {
 public:
  static constexpr rhi::Format kColorFormat = rhi::Format::RGBA16Float;
  static constexpr float kFarDepth = 0;
  static constexpr rhi::CompareOp kNearer = rhi::CompareOp::Greater;
  /// Of layers: one may lie on the far plane, where depth was cleared to.
  static constexpr rhi::CompareOp kNearerOrEqual = rhi::CompareOp::GreaterOrEqual;

  CameraPass(const Context& context, CameraPassDesc desc);

  /// Within a frame, after the scene view has moved.
  void moved(Frame& frame);
  void recordOpaque(Frame& frame);
  void recordTranslucent(Frame& frame);
  /// Some of them, after all behind these.
  void recordTranslucent(Frame& frame, std::span<const uint32_t> part);
  /// What the transparency technique has to say of the last frame. Call between frames.
  std::vector<std::string> warnings();

  /// Of the camera's depth and of everything that is attached in its stead: with stencil where the
  /// shadow technique answers by layers.
  rhi::Format depthFormat() const {
    return m_desc.byLayer ? rhi::Format::D32FloatS8 : rhi::Format::D32Float;
  }
  rhi::TextureId color() const { return m_color; }
  rhi::TextureId depth() const { return m_depth; }
  const VisibilityInputs& inputs() const { return m_desc.inputs; }

  // For transparency techniques.

  /// The layer's surfaces, after the shadow technique has answered for them. `depth` draws the
  /// depth of the layer beforehand; it runs only where the technique answers by layers (byLayer()).
  void recordLayer(Frame& frame, const ReceiverLayer& layer, const std::function<void()>& depth,
                   const std::function<void()>& surfaces) const;
  /// The shadow technique answers by layers of receivers.
  bool byLayer() const { return m_desc.byLayer != nullptr; }

  /// Pipeline of translucent surfaces with `emit` of the technique's folder: reads depth, nearer or
  /// equal, writes none, one colour target without blending. Change what differs, then get it.
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
  /// Where surfaces lie in one plane with opaque ones, depth is not attached but sampled: the
  /// shader tests it (common/opaque_test.glsl, folders `.../coplanar`).
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
  bool coplanar() const { return view().gpu().everCoplanar(); }
  /// The opaque depth as shaders sample it; only where surfaces are coplanar.
  rhi::Binding opaqueDepth() const {
    return rhi::textureAt(TEXTURE_TRANSPARENCY, m_depth, m_depthSampler);
  }
  /// A list of its own, with bindings beside those of visibility.
  DrawList drawListWith(std::span<const rhi::Binding> extra) const;

  // For whatever draws the same surfaces for another purpose.

  enum class Receivers : uint8_t { Opaque, Translucent };
  /// Folder of the shaders that answer for receivers. Translucent ones whose answer is
  /// unrepresented (TechniqueInfo::handsOutLayers) are lit.
  const std::string& folder(Receivers receivers) const;
  /// Name of a shader that shades them.
  std::string shaded(Receivers receivers, const std::string& transparencyFolder,
                     const std::string& pass) const;
  /// A pipeline of surfaces by one of those shaders, writing depth.
  rhi::GraphicsPipelineDesc surfacePipeline(const std::string& label, const std::string& fragment,
                                            bool masked) const;
  const OpaqueSurfaces& opaque() const { return m_opaque; }

 private:
  void recordDepth(Frame& frame);
  void recordShaded(Frame& frame);

  const Context m_context;
  const CameraPassDesc m_desc;
  rhi::Texture m_color, m_depth;
  rhi::Sampler m_depthSampler;
  OpaqueSurfaces m_opaque;
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
