// Soft shadows of one layer of receivers (spec 08): ways to make the share of a light that arrives
// of the volumes of its centre and the wedges around its penumbrae.
#pragma once

#include <functional>
#include <memory>

#include "techniques/volumes/shadow_mask.h"
#include "techniques/volumes/volume_counter.h"
#include "techniques/volumes/wedges/coverage_tables.h"
#include "techniques/volumes/wedges/light_wedges.h"

namespace sb {

/// A light before a layer of receivers, and the slot of the mask that its share goes to.
struct SoftLight {
  Frame& frame;
  const ReceiverLayer& layer;
  const ShadowVolumes& volumes;
  const LightVolumes& light;
  size_t number;  ///< among those of LightWedges
  const ShadowMask& mask;
  uint32_t slot;
};

class SoftShadows {
 public:
  /// The way that the knob `combine` names. `wedges` must outlive it.
  static std::unique_ptr<SoftShadows> make(const Context& context, const LightWedges& wedges);
  SoftShadows(const Context& context, const LightWedges& wedges);
  virtual ~SoftShadows() = default;

  /// Makes what drawing these needs.
  virtual void prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights,
                       const ShadowMask& mask) = 0;
  /// Within a frame: passes that fill the slot.
  virtual void record(const SoftLight& light) const = 0;

 protected:
  /// Of shaders that include penumbra_wedge/wedges.glsl and read the receivers' depth.
  std::vector<rhi::Binding> bindings(const ReceiverLayer& layer, size_t light) const;
  /// One that finds shares of edges: in closed form, or "NAME_tables", of the source's.
  const rhi::ShaderCode* shader(const std::string& name) const;
  /// Of what sums: by the knob `format`.
  rhi::Format format(rhi::Format full, rhi::Format half, rhi::Format bytes) const;
  /// Adds into a target, in a pass over the receivers' depth.
  rhi::GraphicsPipelineDesc wedgePipeline(const rhi::ShaderCode* fragment,
                                          rhi::Format format) const;
  /// A pass that clears a target and sums volumes and wedges there, over the receivers' depth.
  void recordSum(const SoftLight& light, rhi::TextureId target,
                 const std::function<void(rhi::CommandList&)>& body) const;
  void drawWedges(rhi::CommandList& commands, rhi::PipelineId pipeline, const SoftLight& light,
                  const WedgeRange& wedges) const;

  const Context m_context;
  const LightWedges& m_wedges;
  rhi::Sampler m_sampler;

 private:
  std::optional<CoverageTables> m_tables;
};

}  // namespace sb
