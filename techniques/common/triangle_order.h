// Triangles of several instances drawn in an order of their own: where one mesh as a whole has no
// right place among others. Made once for a standing view; draws are runs of one instance each.
#pragma once

#include <functional>

#include "techniques/common/draw_list.h"
#include "techniques/common/technique.h"

namespace sb {

class TriangleOrder {
 public:
  TriangleOrder() = default;
  /// Sorts the triangles of `instances` by `rank` of their centroid (camera-relative world), least
  /// first; persistent keys break ties, so that the order of the file plays no part. `extra`:
  /// bindings of the draws beside the common ones. Pipelines that read a triangle's record need
  /// specialization constant 3.
  TriangleOrder(const Context& context, std::span<const uint32_t> instances,
                const std::function<double(const glm::dvec3&)>& rank,
                std::vector<rhi::Binding> extra);

  void draw(rhi::CommandList& commands, rhi::PipelineId pipeline);

 private:
  struct Run {
    uint32_t instance = 0;
    uint32_t first = 0;  ///< triangle, in sorted order
    uint32_t count = 0;
  };
  void upload(const Context& context, const std::vector<uint32_t>& indices,
              const std::vector<uint32_t>& numbers, std::vector<rhi::Binding> extra);

  const SceneView* m_view = nullptr;
  std::vector<Run> m_runs;
  rhi::Buffer m_indices, m_order, m_draws;
  uint64_t m_drawStride = 0;
  DrawList m_drawList;
};

}  // namespace sb
