// Draws instances of a scene with one set of bindings. Instances that follow one another with one
// pipeline and one material are one call: what tells them apart comes as attributes of the
// instance.
#pragma once

#include <map>
#include <vector>

#include "techniques/draw/views/scene_view.h"

namespace sb {

/// Pipelines of one pass over a depth map: of casters as they are, and of those that rise before
/// themselves (ShadowMaps::pipelines).
struct CasterPipelines {
  rhi::PipelineId exact, receding;
};

class DrawList {
 public:
  DrawList() = default;
  /// `extra`: bindings beside the common ones (pass block, technique's maps). `withAttributes`:
  /// bind normals, uvs and textures too.
  DrawList(const SceneView& view, std::vector<rhi::Binding> extra, bool withAttributes);

  /// Another binding beside the common ones; before the first draw.
  void bind(const rhi::Binding& binding) { m_extra.push_back(binding); }

  /// `copies`: how often each instance is drawn, told apart by InstanceData::order
  /// (SceneView::copyInstances).
  void draw(rhi::CommandList& commands, rhi::PipelineId pipeline,
            std::span<const uint32_t> instances, uint32_t copies = 1);
  /// The same, each instance by its mesh's pipeline.
  void draw(rhi::CommandList& commands, const CasterPipelines& pipelines,
            std::span<const uint32_t> instances, uint32_t copies = 1);
  void draw(rhi::CommandList& commands, rhi::PipelineId pipeline, uint32_t instance) {
    draw(commands, pipeline, std::span(&instance, 1));
  }
  /// Draws parts of another index buffer (triangles in an order of their own) with records of
  /// instances from another vertex buffer.
  void drawOrdered(rhi::CommandList& commands, rhi::PipelineId pipeline, uint32_t material,
                   rhi::BufferId instances, rhi::BufferId indices,
                   std::span<const rhi::DrawIndexedArgs> draws);

 private:
  const std::vector<rhi::Binding>& bindingsOf(uint32_t material);

  const SceneView* m_view = nullptr;
  std::vector<rhi::Binding> m_extra;
  bool m_withAttributes = false;
  std::map<uint32_t, std::vector<rhi::Binding>> m_byMaterial;
  std::vector<rhi::DrawIndexedArgs> m_draws;  ///< kept to spare allocations
};

}  // namespace sb
