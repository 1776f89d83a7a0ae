// What the shadow-map family shares: its knobs, the fitted views of all lights, the depth map of
// every view, and the constants of shaders/common/light_space.glsl.
#pragma once

#include "techniques/draw/draw_list.h"
#include "techniques/plan/lookup_reach.h"
#include "techniques/render/technique.h"

namespace sb {

/// Knobs size, kernel, shape, bias, fit, depth. `defaultKernel`: odd width in texels.
std::vector<KnobInfo> shadowMapKnobs(const std::string& defaultKernel);

/// Of the depth map.
struct DepthShape {
  uint32_t layersPerView = 1;
  uint32_t samples = 1;
  bool reachTranslucent = false;  ///< see LightFitSettings
};

class ShadowMaps {
 public:
  /// Has the scene view fit the lights, now and whenever the camera moves, and creates the depth
  /// map, one layer a view unless `shape` says otherwise. `depthStep`: coarsest step of the formats
  /// that lookups read. Throws rhi::Error when the device has no such depth map.
  ShadowMaps(const Context& context, float depthStep, DepthShape shape = {});

  /// Refitted whenever the camera moves; each view keeps its place and its layer.
  const std::vector<LightView>& views() const { return m_view.lightViews(); }
  uint32_t size() const { return m_size; }
  uint32_t layers() const { return m_layers; }
  rhi::Format depthFormat() const { return m_depthFormat; }
  const rhi::Texture& depth() const { return m_depth; }
  /// Another map of the same size, one layer a view unless `layers` says otherwise. Throws
  /// rhi::Error when the device cannot render to, or blend, the format.
  rhi::Texture createLike(const Context& context, const std::string& label, rhi::Format format,
                          uint32_t layers = 0) const;
  /// Clears a map now: one that some step of a camera's path reads before any has written it.
  static void clear(const Context& context, const rhi::Texture& map);
  rhi::SamplerId pointSampler() const { return m_pointSampler; }

  /// Half a lookup's width for a light: texels of the filter, and where in its texel a receiver
  /// lies.
  LookupReach reach(uint32_t sceneLight) const;

  /// Constants 16..18 and 23 of light_space.glsl.
  std::vector<rhi::SpecConstant> constants(const Knobs& knobs) const;
  /// Depth-only pipeline of casters; add what differs. `surface`: with uvs and textures.
  rhi::GraphicsPipelineDesc casterPipeline(const Context& context, const std::string& label,
                                           const std::string& fragment, bool masked) const;
  /// The pipeline of `desc` (casterPipeline and what differs), and where bias is by the receiver's
  /// plane and some caster rises before itself, another for these casters: its fragment shader is
  /// NAME_receding where depth is written, NAME itself where it is only tested, and gets the reach
  /// of lookups. Scenes of flat and convex casters have the first alone.
  CasterPipelines pipelines(const Context& context, const rhi::GraphicsPipelineDesc& desc) const;
  /// Some casters rise before themselves, and the maps hold receding depths of them.
  bool recedes() const { return m_recedes > 0; }
  /// Bindings of a light pass: the pass block of one view.
  rhi::Binding passBlock(size_t view) const;
  /// Attachment of one view's layers.
  rhi::DepthAttachment depthAttachment(const LightView& view) const;
  /// A binding of every pass that draws surfaces; before the first draw.
  void bind(const rhi::Binding& binding) {
    for (DrawList& list : m_surfaces) list.bind(binding);
  }
  /// Draw lists of a view's casters: positions only, and with attributes.
  DrawList& plain(size_t view) { return m_plain[view]; }
  DrawList& surfaces(size_t view) { return m_surfaces[view]; }

 private:
  const SceneView& m_view;
  uint32_t m_size = 0;
  uint32_t m_kernel = 1;
  float m_recedes = 0;  ///< reach of lookups in texels where concave casters recede; 0: none do
  uint32_t m_layers = 0;
  DepthShape m_shape;
  rhi::Format m_depthFormat = rhi::Format::D32Float;
  rhi::Texture m_depth;
  rhi::Buffer m_passBlocks;
  uint64_t m_passStride = 256;
  rhi::Sampler m_pointSampler;
  std::vector<DrawList> m_plain, m_surfaces;
};

/// Knob msaa: samples of a texel. (`samples` is StochasticTransparency's.)
KnobInfo mapSamplesKnob();

/// Step of depth that storing in a format rounds to; 0 for floats, which keep what was computed.
float depthStep(rhi::Format format);

}  // namespace sb
