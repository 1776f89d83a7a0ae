// Draws and dispatches. Many draws a frame differ in little, so everything is compared with what is
// bound, and only what differs is bound again.
#include <algorithm>
#include <cassert>

#include "backends/vulkan/commands/vk_command_list.h"

namespace vulkan {
namespace {

bool operator==(const VkRect2D& a, const VkRect2D& b) {
  return a.offset.x == b.offset.x && a.offset.y == b.offset.y && a.extent.width == b.extent.width &&
         a.extent.height == b.extent.height;
}

bool operator!=(const rhi::Viewport& a, const rhi::Viewport& b) {
  return a.x != b.x || a.y != b.y || a.width != b.width || a.height != b.height ||
         a.minDepth != b.minDepth || a.maxDepth != b.maxDepth;
}

/// Vulkan forbids negative offsets; what lies outside the target is not drawn anyway.
VkRect2D scissorOf(const rhi::Rect& rect) {
  const int64_t x0 = std::max<int64_t>(rect.x, 0), y0 = std::max<int64_t>(rect.y, 0);
  const int64_t x1 = std::max(int64_t(rect.x) + rect.width, x0);
  const int64_t y1 = std::max(int64_t(rect.y) + rect.height, y0);
  return {{int32_t(x0), int32_t(y0)}, {uint32_t(x1 - x0), uint32_t(y1 - y0)}};
}

}  // namespace

bool CommandList::sameContent(const Bound& bound, std::span<const rhi::Binding> bindings) {
  if (bindings.size() != bound.bindings.size()) return false;
  for (size_t i = 0; i < bindings.size(); ++i) {
    const rhi::Binding& a = bindings[i];
    const rhi::Binding& b = bound.bindings[i];
    if (a.slot != b.slot || a.buffer != b.buffer || a.size != b.size || !(a.view == b.view) ||
        a.sampler != b.sampler)
      return false;
    // Of a uniform buffer given by size, the offset is no content.
    const bool dynamic = a.slot < rhi::kStorageSlotBase && a.size != rhi::kWholeSize;
    if (a.offset != b.offset && !dynamic) return false;
  }
  return true;
}

void CommandList::findSet(const Pipeline& pipeline, Bound& bound,
                          std::span<const rhi::Binding> bindings) {
  Descriptors::Table table = {};
  for (const rhi::Binding& binding : bindings) {
    assert(binding.slot < rhi::kSlotCount);
    table[binding.slot] = &binding;
  }
  uint32_t uniform = 0;
  for (const auto& [slot, type] : pipeline.layout->slots) {
    if (!table[slot])
      throw rhi::Error("draw", "",
                       "pipeline '" + pipeline.label + "' uses slot " + std::to_string(slot) +
                           ", which is not bound");
    if (slot < rhi::kStorageSlotBase)
      bound.uniformAt[uniform++] = size_t(table[slot] - bindings.data());
  }
  bound.set = m_device.descriptors().get(*pipeline.layout, table);
  bound.bindings.assign(bindings.begin(), bindings.end());
}

void CommandList::bindResources(const Pipeline& pipeline, Bound& bound,
                                std::span<const rhi::Binding> bindings) {
  const PipelineLayout& layout = *pipeline.layout;
  if (layout.slots.empty()) return;
  const bool sameLayout = bound.layout == &layout;
  const VkDescriptorSet before = bound.set;
  if (!sameLayout || !sameContent(bound, bindings)) findSet(pipeline, bound, bindings);
  bound.layout = &layout;
  bool changed = !sameLayout || bound.set != before;
  for (uint32_t i = 0; i < layout.uniformCount; ++i) {
    const auto offset = uint32_t(bindings[bound.uniformAt[i]].offset);
    changed |= bound.offsets[i] != offset;
    bound.offsets[i] = offset;
  }
  if (!changed) return;
  m_vk.vkCmdBindDescriptorSets(m_commands, pipeline.bindPoint, layout.layout, 0, 1, &bound.set,
                               layout.uniformCount, bound.offsets.data());
}

void CommandList::setDynamic(const rhi::DrawState& state) {
  const bool first = !m_raster.dynamicSet;
  m_raster.dynamicSet = true;
  const rhi::Viewport viewport = state.viewport.value_or(
      rhi::Viewport{.width = float(m_extent.width), .height = float(m_extent.height)});
  if (first || viewport != m_raster.viewport) {
    m_raster.viewport = viewport;
    const VkViewport native = {viewport.x,      viewport.y,        viewport.width,
                               viewport.height, viewport.minDepth, viewport.maxDepth};
    m_vk.vkCmdSetViewport(m_commands, 0, 1, &native);
  }
  const VkRect2D scissor =
      scissorOf(state.scissor.value_or(rhi::Rect{0, 0, m_extent.width, m_extent.height}));
  if (first || !(scissor == m_raster.scissor)) {
    m_raster.scissor = scissor;
    m_vk.vkCmdSetScissor(m_commands, 0, 1, &scissor);
  }
  if (first || state.stencilReference != m_raster.stencilReference) {
    m_raster.stencilReference = state.stencilReference;
    m_vk.vkCmdSetStencilReference(m_commands, VK_STENCIL_FACE_FRONT_AND_BACK,
                                  state.stencilReference);
  }
  if (first || state.blendConstant != m_raster.blendConstant) {
    m_raster.blendConstant = state.blendConstant;
    m_vk.vkCmdSetBlendConstants(m_commands, state.blendConstant.data());
  }
}

void CommandList::bindBuffers(const rhi::DrawState& state, bool indexed) {
  const bool sameVertices = std::ranges::equal(
      state.vertexBuffers, m_raster.vertexBuffers,
      [](const auto& a, const auto& b) { return a.buffer == b.buffer && a.offset == b.offset; });
  if (!sameVertices) {
    m_raster.vertexBuffers.assign(state.vertexBuffers.begin(), state.vertexBuffers.end());
    std::array<VkBuffer, 16> buffers;
    std::array<VkDeviceSize, 16> offsets;
    assert(state.vertexBuffers.size() <= buffers.size());
    for (size_t i = 0; i < state.vertexBuffers.size(); ++i) {
      buffers[i] = m_device.get(state.vertexBuffers[i].buffer).handle;
      offsets[i] = state.vertexBuffers[i].offset;
    }
    if (!state.vertexBuffers.empty())
      m_vk.vkCmdBindVertexBuffers(m_commands, 0, uint32_t(state.vertexBuffers.size()),
                                  buffers.data(), offsets.data());
  }
  if (!indexed ||
      (state.indexBuffer == m_raster.indexBuffer && state.indexOffset == m_raster.indexOffset &&
       state.indexType == m_raster.indexType))
    return;
  m_raster.indexBuffer = state.indexBuffer;
  m_raster.indexOffset = state.indexOffset;
  m_raster.indexType = state.indexType;
  m_vk.vkCmdBindIndexBuffer(
      m_commands, m_device.get(state.indexBuffer).handle, state.indexOffset,
      state.indexType == rhi::IndexType::Uint16 ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32);
}

void CommandList::bindDraw(const rhi::DrawState& state, bool indexed) {
  assert(m_rendering && "draws belong to graphics passes");
  const Pipeline& pipeline = m_device.get(state.pipeline);
  if (pipeline.handle != m_graphics.pipeline) {
    m_graphics.pipeline = pipeline.handle;
    m_vk.vkCmdBindPipeline(m_commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.handle);
  }
  setDynamic(state);
  bindBuffers(state, indexed);
  bindResources(pipeline, m_graphics, state.bindings);
}

void CommandList::doDraw(const rhi::DrawState& state, const rhi::DrawArgs& args) {
  bindDraw(state, false);
  m_vk.vkCmdDraw(m_commands, args.vertexCount, args.instanceCount, args.firstVertex, 0);
}

void CommandList::doDrawIndexed(const rhi::DrawState& state,
                                std::span<const rhi::DrawIndexedArgs> draws) {
  bindDraw(state, true);
  for (const rhi::DrawIndexedArgs& args : draws)
    m_vk.vkCmdDrawIndexed(m_commands, args.indexCount, args.instanceCount, args.firstIndex,
                          args.vertexOffset, args.firstInstance);
}

void CommandList::doDrawIndirect(const rhi::DrawState& state, const rhi::IndirectArgs& args,
                                 bool indexed) {
  bindDraw(state, indexed);
  const VkBuffer buffer = m_device.get(args.buffer).handle;
  const uint32_t stride = args.stride ? args.stride : (indexed ? 20 : 16);
  const auto call = indexed ? m_vk.vkCmdDrawIndexedIndirect : m_vk.vkCmdDrawIndirect;
  if (m_context.features().multiDrawIndirect || args.drawCount <= 1) {
    call(m_commands, buffer, args.offset, args.drawCount, stride);
    return;
  }
  for (uint32_t i = 0; i < args.drawCount; ++i)
    call(m_commands, buffer, args.offset + uint64_t(i) * stride, 1, stride);
}

void CommandList::doDispatch(const rhi::DispatchState& state, uint32_t x, uint32_t y, uint32_t z) {
  assert(!m_rendering && "dispatches belong to compute passes");
  const Pipeline& pipeline = m_device.get(state.pipeline);
  if (pipeline.handle != m_compute.pipeline) {
    m_compute.pipeline = pipeline.handle;
    m_vk.vkCmdBindPipeline(m_commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle);
  }
  bindResources(pipeline, m_compute, state.bindings);
  m_vk.vkCmdDispatch(m_commands, x, y, z);
}

void CommandList::doDispatchIndirect(const rhi::DispatchState& state, rhi::BufferId args,
                                     uint64_t offset) {
  assert(!m_rendering && "dispatches belong to compute passes");
  const Pipeline& pipeline = m_device.get(state.pipeline);
  if (pipeline.handle != m_compute.pipeline) {
    m_compute.pipeline = pipeline.handle;
    m_vk.vkCmdBindPipeline(m_commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle);
  }
  bindResources(pipeline, m_compute, state.bindings);
  m_vk.vkCmdDispatchIndirect(m_commands, m_device.get(args).handle, offset);
}

}  // namespace vulkan
