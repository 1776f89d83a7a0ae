// Counting of shadow volumes at each pixel's receiver (spec 07): entered less left, before it or
// behind it, by the stencil (modulo 256) or by adding in a float target (exact to 2^24).
#pragma once

#include <compare>
#include <map>

#include "techniques/volumes/shadow_volumes.h"

namespace sb {

enum class VolumeFaces : uint8_t {
  Both,  ///< each volume once, both faces counted
  Each,  ///< faces toward the eye first, then the others
};
enum class CounterKind : uint8_t { Stencil, Float };

class VolumeCounter {
 public:
  static constexpr rhi::Format kDepthFormat = rhi::Format::D32FloatS8;
  /// Of volumes that lie before receivers: strictly.
  static constexpr rhi::CompareOp kBefore = rhi::CompareOp::Greater;
  static constexpr rhi::Format kFloatFormat = rhi::Format::R32Float;

  /// `format`: of the target of CounterKind::Float, whose first channel counts; of bytes, the first
  /// those entered and the second those left.
  VolumeCounter(const Context& context, CounterKind kind, VolumeFaces faces,
                rhi::Format format = kFloatFormat)
      : m_context(context), m_kind(kind), m_faces(faces), m_format(format) {}

  /// Makes what drawing these volumes needs.
  void prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights);
  /// Within a pass over the receivers' depth, read only: its stencil counts, or the one colour
  /// target. Both start at 0, and are 0 where no volume is. `casters`: of the light, all or some;
  /// `loop`: of one caster, what it keeps from the light.
  void draw(rhi::CommandList& commands, const ShadowVolumes& volumes, const LightVolumes& light,
            std::span<const CasterVolume> casters, const SilhouetteLoop* loop = nullptr) const;

 private:
  struct Variant {
    uint32_t part;
    DepthCount count;
    rhi::CullMode cull;
    uint32_t caps;  ///< CAPS_*; CAPS_BOTH: of the sides too
    auto operator<=>(const Variant&) const = default;
  };
  std::vector<rhi::CullMode> culls() const;
  /// Variant::caps with which a part is drawn.
  static std::span<const uint32_t> capsOf(const CasterVolume& volume, uint32_t part);
  rhi::GraphicsPipelineDesc desc(const ShadowVolumes& volumes, const Variant& variant) const;

  const Context m_context;
  const CounterKind m_kind;
  const VolumeFaces m_faces;
  const rhi::Format m_format;
  std::map<Variant, rhi::PipelineId> m_pipelines;
};

}  // namespace sb
