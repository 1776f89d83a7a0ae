#include "techniques/draw/draw_list.h"

namespace sb {

DrawList::DrawList(const SceneView& view, std::vector<rhi::Binding> extra, bool withAttributes)
    : m_view(&view), m_extra(std::move(extra)), m_withAttributes(withAttributes) {}

std::vector<rhi::Binding>& DrawList::bindingsOf(uint32_t material) {
  // Without textures every material draws with the same bindings.
  if (!m_withAttributes || !m_view->gpu().textured()) material = 0;
  auto [it, isNew] = m_byMaterial.try_emplace(material);
  if (isNew) {
    it->second = m_view->bindings();
    it->second.insert(it->second.end(), m_extra.begin(), m_extra.end());
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
  const rhi::VertexBufferBinding vertexBuffers[] = {{gpu.positions(), 0}, {gpu.attributes(), 0}};
  for (uint32_t i : instances) {
    const uint32_t meshIndex = m_view->scene().instances[i].mesh;
    const GpuScene::MeshRange& mesh = gpu.mesh(meshIndex);
    auto& bindings = bindingsOf(m_view->scene().meshes[meshIndex].material);
    bindings.front().offset = m_view->drawOffset(i);
    commands.drawIndexed(
        {.pipeline = gpu.rises(i) && pipelines.receding != rhi::PipelineId{} ? pipelines.receding
                                                                             : pipelines.exact,
         .bindings = bindings,
         .vertexBuffers = std::span(vertexBuffers, m_withAttributes ? 2 : 1),
         .indexBuffer = gpu.indices()},
        {.indexCount = mesh.indexCount,
         .instanceCount = copies,
         .firstIndex = mesh.firstIndex,
         .vertexOffset = mesh.vertexOffset});
  }
}

void DrawList::drawOrdered(rhi::CommandList& commands, rhi::PipelineId pipeline, uint32_t material,
                           const rhi::Binding& drawBinding, rhi::BufferId indices,
                           const rhi::DrawIndexedArgs& args) {
  const GpuScene& gpu = m_view->gpu();
  const rhi::VertexBufferBinding vertexBuffers[] = {{gpu.positions(), 0}, {gpu.attributes(), 0}};
  auto& bindings = bindingsOf(material);
  const rhi::Binding usual = bindings.front();
  bindings.front() = drawBinding;
  commands.drawIndexed({.pipeline = pipeline,
                        .bindings = bindings,
                        .vertexBuffers = std::span(vertexBuffers, m_withAttributes ? 2 : 1),
                        .indexBuffer = indices},
                       args);
  bindings.front() = usual;
}

}  // namespace sb
