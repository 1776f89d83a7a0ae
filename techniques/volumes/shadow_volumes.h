// Shadow volumes on the device, however their items are found:
//   Cpu       the silhouette on the CPU, uploaded when light, caster or camera have moved
//   Vertex    sides at every edge, caps at every triangle, most of them without area
//   Geometry  the same, but for sides, which a geometry shader makes of a list of edges
//   Compute   a compute shader appends to lists that are drawn indirectly, every frame
// All draw the same bits.
#pragma once

#include <functional>

#include "techniques/draw/context.h"
#include "techniques/draw/frame/frame.h"
#include "techniques/volumes/silhouette_loops.h"

namespace sb {

enum class VolumeBuilder : uint8_t { Cpu, Vertex, Geometry, Compute };

class ShadowVolumes {
 public:
  /// For a view that shows a whole path. `visit`: told the volumes of every step.
  ShadowVolumes(const Context& context, VolumeBuilder builder, const VolumeChoice& choice,
                const CullingChoice& culling,
                const std::function<void(const std::vector<LightVolumes>&)>& visit);

  /// Of this step: of lights that something casts in.
  const std::vector<LightVolumes>& lights() const { return m_lights; }
  /// Items of a part of a volume; VolumeBuilder::Cpu alone.
  std::span<const uint32_t> items(const CasterVolume& volume, uint32_t part) const {
    return std::span(m_items).subspan(m_firstItem[volume.number] + volume.data.lists[int(part)],
                                      volume.items[part]);
  }
  /// VolumeChoice::byLoops: those of a volume's items.
  std::span<const SilhouetteLoop> loops(const CasterVolume& volume) const {
    return m_choice.byLoops ? m_loops[volume.number] : std::span<const SilhouetteLoop>();
  }
  const EdgeBuffers::MeshEdges& edges(uint32_t mesh) const { return m_edges.of(mesh); }
  /// Of this step, as records name them: what was left out, and what is drawn.
  std::vector<std::pair<std::string, uint64_t>> counts() const;

  /// Within a frame, after the view has moved.
  void moved(Frame& frame);
  /// Passes before volumes are drawn.
  void record(Frame& frame);

  /// Stages, topology and constants of what draws a part of volumes (VOLUME_*, CAPS_*).
  rhi::GraphicsPipelineDesc pipeline(uint32_t part, uint32_t caps) const;
  /// What passes that draw volumes read.
  std::vector<rhi::ResourceUse> reads() const;
  /// `loop`: its items alone; VolumeBuilder::Cpu.
  void draw(rhi::CommandList& commands, rhi::PipelineId pipeline, const LightVolumes& light,
            const CasterVolume& volume, uint32_t part, const SilhouetteLoop* loop = nullptr) const;

 private:
  using Write = std::function<void(rhi::BufferId, std::span<const std::byte>)>;
  bool hasGeometryShader(uint32_t part) const {
    return m_builder == VolumeBuilder::Geometry && part == VOLUME_SIDES;
  }
  bool listed() const {
    return m_builder == VolumeBuilder::Cpu || m_builder == VolumeBuilder::Compute;
  }
  std::vector<uint32_t> casterMeshes() const;
  void update(const std::vector<LightCasters>& casters);
  /// Room for the lists of the casters wherever a camera stands that is set freely.
  uint64_t itemsFromAnywhere() const;
  void findItems(CasterVolume& volume, uint32_t light);
  void createBuffers();
  void bind();
  void write(const Write& write) const;

  const Context m_context;
  const VolumeBuilder m_builder;
  const VolumeChoice m_choice;
  ShadowCulling m_culling;
  EdgeBuffers m_edges;
  std::vector<LightVolumes> m_lights;
  Silhouettes m_silhouettes;
  std::vector<uint32_t> m_items;                      ///< of all lists, Cpu
  std::vector<uint64_t> m_firstItem;                  ///< of each volume's lists
  std::vector<std::vector<SilhouetteLoop>> m_loops;   ///< of each volume
  uint64_t m_itemCount = 0;                           ///< of this step
  uint64_t m_mostItems = 0, m_mostVolumes = 0;        ///< of any step
  std::vector<std::vector<rhi::Binding>> m_bindings;  ///< of each volume
  rhi::Buffer m_volumeBlocks, m_itemLists, m_arguments, m_noArguments;
  rhi::PipelineId m_append;
};

}  // namespace sb
