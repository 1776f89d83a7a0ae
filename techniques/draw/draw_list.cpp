#include "techniques/draw/draw_list.h"

namespace sb {

DrawList::DrawList(const SceneView& view, std::vector<rhi::Binding> extra, bool withAttributes)
    : m_view(&view), m_extra(std::move(extra)), m_withAttributes(withAttributes) {}

const std::vector<rhi::Binding>& DrawList::bindingsOf(uint32_t material) {
  auto [it, isNew] = m_byMaterial.try_emplace(material);
  if (isNew) {
    it->second = m_view->bindings();
    it->second.insert(it->second.end(), m_extra.begin(), m_extra.end());
    it->second.push_back(m_view->gpu().material(material));
    if (m_withAttributes) {
      const auto& textures = m_view->gpu().textures(material);
      it->second.insert(it->second.end(), textures.begin(), textures.end());
    }
  }
  return it->second;
}

void DrawList::draw(rhi::CommandList& commands, rhi::PipelineId pipeline,
                    std::span<const uint32_t> instances, uint32_t copies) {
  draw(commands, CasterPipelines{pipeline, pipeline}, instances, copies);
}

void DrawList::draw(rhi::CommandList& commands, const CasterPipelines& pipelines,
                    std::span<const uint32_t> instances, uint32_t copies) {
  const GpuScene& gpu = m_view->gpu();
  auto pipelineOf = [&](uint32_t i) {
    return gpu.rises(i, m_view->step()) && pipelines.receding != rhi::PipelineId{}
               ? pipelines.receding
               : pipelines.exact;
  };
  auto materialOf = [&](uint32_t i) {
    // Depths alone look at no material.
    return m_withAttributes ? m_view->scene().meshes[m_view->scene().instances[i].mesh].material
                            : 0;
  };
  for (size_t first = 0; first < instances.size();) {
    const rhi::PipelineId pipeline = pipelineOf(instances[first]);
    const uint32_t material = materialOf(instances[first]);
    m_draws.clear();
    size_t i = first;
    for (; i < instances.size() && pipelineOf(instances[i]) == pipeline &&
           materialOf(instances[i]) == material;
         ++i) {
      const GpuScene::MeshRange& mesh = gpu.mesh(m_view->scene().instances[instances[i]].mesh);
      m_draws.push_back({.indexCount = mesh.indexCount,
                         .instanceCount = copies,
                         .firstIndex = mesh.firstIndex,
                         .vertexOffset = mesh.vertexOffset,
                         .firstInstance = instances[i] * copies});
    }
    drawOrdered(commands, pipeline, material, m_view->instances(copies), gpu.indices(), m_draws);
    first = i;
  }
}

void DrawList::drawOrdered(rhi::CommandList& commands, rhi::PipelineId pipeline, uint32_t material,
                           rhi::BufferId instances, rhi::BufferId indices,
                           std::span<const rhi::DrawIndexedArgs> draws) {
  const GpuScene& gpu = m_view->gpu();
  std::vector<rhi::VertexBufferBinding> buffers = {{gpu.positions()}};
  if (m_withAttributes) buffers.push_back({gpu.attributes()});
  buffers.push_back({instances});
  commands.drawIndexed({.pipeline = pipeline,
                        .bindings = bindingsOf(material),
                        .vertexBuffers = buffers,
                        .indexBuffer = indices},
                       draws);
}

}  // namespace sb
