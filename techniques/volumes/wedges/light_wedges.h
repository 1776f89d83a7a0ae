// The wedges of the lights of a frame whose penumbrae are seen (spec 08): the edges of silhouettes
// that their volumes were made of, with the hulls of their penumbrae, and the casters that they
// belong to with their triangles, as shaders read them (shaders/common/shared_wedge.h). Found on
// the CPU anew at every step: all of it depends on where light, caster and eye are.
#pragma once

#include "shaders/common/shared_wedge.h"
#include "techniques/volumes/shadow_volumes.h"
#include "techniques/volumes/wedges/wedge.h"

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

  /// Lights in the order of `find`; casters in that of LightVolumes. Among those that the light's
  /// bindings show.
  WedgeRange ofLight(size_t light) const { return {0, m_lights[light].wedges.count}; }
  WedgeRange ofCaster(size_t light, size_t caster) const {
    const glm::uvec4 parts = m_casters[m_lights[light].casters.first + caster].parts;
    return {parts.x, parts.y};
  }
  /// VolumeChoice::byLoops: of each loop of a caster.
  std::span<const WedgeRange> ofLoops(size_t light, size_t caster) const {
    return m_loops[m_lights[light].firstLoops + caster];
  }
  /// Else it is drawn everywhere. `wedge`: of the light.
  bool hasHull(size_t light, uint32_t wedge) const {
    return m_wedges[m_lights[light].wedges.first + wedge].end.w == 0;
  }
  const std::vector<rhi::Binding>& bindings(size_t light) const { return m_lights[light].bindings; }

  /// Wedges of this step, of all that casts, a floor's edges too; and those that were not shown to
  /// hold their penumbra.
  size_t count() const { return m_count; }
  size_t everywhere() const { return m_everywhere; }

 private:
  /// Of one light, in the buffers.
  struct LightRange {
    WedgeRange wedges, casters, triangles;
    size_t firstLoops = 0;  ///< of its first caster
    std::vector<rhi::Binding> bindings;
  };
  void addLight(const ShadowVolumes& volumes, const LightVolumes& light);
  void addCaster(const ShadowVolumes& volumes, const CasterVolume& volume, const WedgeLight& light,
                 const LightRange& range);
  /// Of some of a caster's sides.
  WedgeRange addEdges(const ShadowVolumes& volumes, const CasterVolume& volume,
                      const WedgeLight& light, const LightRange& range,
                      std::span<const uint32_t> sides);
  /// `a`, `b`: in mesh space.
  void addWedge(const WedgeLight& light, const CasterVolume& volume, const glm::vec3& a,
                const glm::vec3& b, float times);
  void bind();

  const Context m_context;
  uint64_t m_mostWedges = 0, m_mostCasters = 0, m_mostTriangles = 0, m_mostLights = 0;
  std::vector<gpu::WedgeData> m_wedges;  ///< each light's start where a binding may
  std::vector<gpu::WedgeCaster> m_casters;
  std::vector<gpu::WedgeTriangle> m_triangles;
  std::vector<LightRange> m_lights;
  std::vector<std::vector<WedgeRange>> m_loops;  ///< of each caster
  double m_reach = 0;                            ///< of parallel eyes: hulls end there
  size_t m_count = 0, m_everywhere = 0;
  rhi::Buffer m_wedgeBuffer, m_casterBuffer, m_triangleBuffer, m_lightBlocks;
};

}  // namespace sb
