// Triangles of several instances drawn in an order of their own: where one mesh as a whole has no
// right place among others. Sorted once for a standing scene, and again in each frame of a moving
// one; draws are runs of one instance each.
#pragma once

#include <functional>

#include "techniques/draw/context.h"
#include "techniques/draw/draw_list.h"

namespace sb {

class TriangleOrder {
 public:
  TriangleOrder() = default;
  /// Instances whose triangles are drawn, as the view stands now.
  using Instances = std::function<std::span<const uint32_t>()>;
  using Rank = std::function<double(const glm::dvec3&)>;

  /// Sorts the triangles of `instances` by `rank` of their centroid (camera-relative world), least
  /// first; of triangles in one place the last by persistent keys comes first, so that the order of
  /// the file plays no part and the first one is the nearest layer. `extra`:
  /// bindings of the draws beside the common ones. Pipelines that read a triangle's record need
  /// specialization constant 3. Both functions are asked again by `sort`.
  TriangleOrder(const Context& context, Instances instances, Rank rank,
                std::vector<rhi::Binding> extra);

  /// Anew, after the view has moved.
  void sort(rhi::CommandList& commands);
  void draw(rhi::CommandList& commands, rhi::PipelineId pipeline);

 private:
  struct Run {
    uint32_t instance = 0;
    uint32_t first = 0;  ///< triangle, in sorted order
    uint32_t count = 0;
  };
  struct Entry {
    double rank = 0;
    uint32_t meshKey = 0, instanceKey = 0, triangleKey = 0, instance = 0, triangle = 0;
  };
  void sortEntries();
  /// Fills the host's copies of the buffers.
  void order();

  const SceneView* m_view = nullptr;
  Instances m_from;
  Rank m_rank;
  std::vector<std::vector<glm::dvec3>> m_centroids;  ///< by mesh, in its own space; those asked for
  std::vector<Entry> m_entries;
  std::vector<Run> m_runs;
  std::vector<uint32_t> m_sortedIndices, m_numbers;
  std::vector<gpu::InstanceData> m_records;   ///< by run
  std::vector<rhi::DrawIndexedArgs> m_draws;  ///< kept to spare allocations
  rhi::Buffer m_indices, m_order, m_instances;
  DrawList m_drawList;
};

}  // namespace sb
