// The wedges of the lights of a frame whose penumbrae are seen (spec 08): the edges of silhouettes
// that their volumes were made of, with the hulls of their penumbrae, and the casters that they
// belong to, as shaders read them (shaders/common/shared_wedge.h). Found on the CPU anew at every
// step: all of it depends on where light, caster and eye are.
#pragma once

#include "shaders/common/shared_wedge.h"
#include "techniques/volumes/shadow_volumes.h"
#include "techniques/volumes/wedge.h"

namespace sb {

/// Of one light, or one caster in it.
struct WedgeRange {
  uint32_t first = 0, count = 0;
};

class LightWedges {
 public:
  /// Storage slots (of techniques) and the uniform slot that shaders of wedges read:
  /// shaders/penumbra_wedge/wedges.glsl.
  explicit LightWedges(const Context& context) : m_context(context) {}

  /// Makes room for what a step needs; its volumes' lists are not read.
  void reserve(std::span<const LightVolumes* const> lights);
  void createBuffers();

  using Write = std::function<void(rhi::BufferId, std::span<const std::byte>)>;
  /// Of these lights, as they are now. `volumes`: theirs, VolumeBuilder::Cpu.
  void find(const ShadowVolumes& volumes, std::span<const LightVolumes* const> lights,
            const Write& write);

  /// Lights in the order of `find`; casters in that of LightVolumes.
  WedgeRange ofLight(size_t light) const { return m_lights[light].wedges; }
  WedgeRange ofCaster(size_t light, size_t caster) const {
    const glm::uvec4 w = m_casters[m_lights[light].casters.first + caster].wedges;
    return {w.x, w.y};
  }
  size_t casters(size_t light) const { return m_lights[light].casters.count; }
  const std::vector<rhi::Binding>& bindings(size_t light) const { return m_lights[light].bindings; }

  /// Wedges of this step, and those that were not shown to hold their penumbra.
  size_t count() const { return m_wedges.size(); }
  size_t everywhere() const { return m_everywhere; }

 private:
  struct LightRange {
    WedgeRange wedges, casters;
    std::vector<rhi::Binding> bindings;
  };
  void addCaster(const ShadowVolumes& volumes, const CasterVolume& volume, const WedgeLight& light);
  void addWedge(const WedgeLight& light, const glm::vec3& a, const glm::vec3& b, float times);
  void bind();

  const Context m_context;
  uint64_t m_mostWedges = 0, m_mostCasters = 0, m_mostLights = 0;
  std::vector<gpu::WedgeData> m_wedges;
  std::vector<gpu::WedgeCaster> m_casters;
  std::vector<LightRange> m_lights;
  double m_reach = 0;  ///< of parallel eyes: hulls end there
  size_t m_everywhere = 0;
  rhi::Buffer m_wedgeBuffer, m_casterBuffer, m_lightBlocks;
};

}  // namespace sb
