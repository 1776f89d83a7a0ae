// Hard shadows of one layer of receivers (spec 07): a pass that counts volumes, and one that fills
// a slot of the mask where the count is not 0.
#pragma once

#include "techniques/volumes/shadow_mask.h"
#include "techniques/volumes/volume_counter.h"

namespace sb {

/// Of each light in view its place among those that something casts in; NO_SHADOW: it is none.
std::vector<uint32_t> maskSlots(const SceneView& view, const std::vector<LightVolumes>& lights);

class HardShadows {
 public:
  HardShadows(const Context& context, CounterKind kind, VolumeFaces faces)
      : m_context(context), m_kind(kind), m_counter(context, kind, faces) {}

  /// Makes what drawing these needs.
  void prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights,
               const ShadowMask& mask);
  /// Within a frame: the shadows of all these lights in one slot.
  void record(Frame& frame, const ReceiverLayer& layer, const ShadowVolumes& volumes,
              std::span<const LightVolumes> lights, const ShadowMask& mask, uint32_t slot) const;

 private:
  void recordVolumes(Frame& frame, const ReceiverLayer& layer, const ShadowVolumes& volumes,
                     std::span<const LightVolumes> lights) const;
  void recordMask(Frame& frame, const ReceiverLayer& layer, const ShadowMask& mask,
                  uint32_t slot) const;

  const Context m_context;
  const CounterKind m_kind;
  VolumeCounter m_counter;
  rhi::TextureId m_counts{};  ///< CounterKind::Float
  rhi::Sampler m_sampler;
  std::vector<rhi::PipelineId> m_maskPipelines;  ///< by channel
};

}  // namespace sb
