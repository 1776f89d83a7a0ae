#include "backends/opengl/commands/gl_command_list.h"

#include <algorithm>
#include <cassert>

#include "backends/opengl/device/gl_debug.h"

namespace opengl {

CommandList::CommandList(Context& context, Objects& objects, State& state,
                         FramebufferCache& framebuffers, Barriers& barriers)
    : m_context(context),
      m_objects(objects),
      m_state(state),
      m_framebuffers(framebuffers),
      m_barriers(barriers) {}

void CommandList::doDraw(const rhi::DrawState& state, const rhi::DrawArgs& args) {
  const Functions& gl = m_context.use();
  m_state.applyDraw(state, false);
  gl.DrawArraysInstanced(m_objects.pipelines.get(state.pipeline).topology(),
                         GLint(args.firstVertex), GLsizei(args.vertexCount),
                         GLsizei(args.instanceCount));
}

void CommandList::doDrawIndexed(const rhi::DrawState& state,
                                std::span<const rhi::DrawIndexedArgs> draws) {
  const Functions& gl = m_context.use();
  m_state.applyDraw(state, true);
  const bool shorts = state.indexType == rhi::IndexType::Uint16;
  const GLenum type = shorts ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  const GLenum mode = m_objects.pipelines.get(state.pipeline).topology();
  for (const rhi::DrawIndexedArgs& args : draws) {
    const uint64_t offset = state.indexOffset + uint64_t(args.firstIndex) * (shorts ? 2 : 4);
    gl.DrawElementsInstancedBaseVertexBaseInstance(
        mode, GLsizei(args.indexCount), type, reinterpret_cast<const void*>(offset),
        GLsizei(args.instanceCount), args.vertexOffset, args.firstInstance);
  }
}

void CommandList::doDrawIndirect(const rhi::DrawState& state, const rhi::IndirectArgs& args,
                                 bool indexed) {
  // OpenGL counts an indirect draw's firstIndex from the start of the index buffer.
  assert((!indexed || state.indexOffset == 0) && "indirect indexed draws take no indexOffset");
  const Functions& gl = m_context.use();
  m_state.applyDraw(state, indexed);
  m_state.bindIndirect(GL_DRAW_INDIRECT_BUFFER, args.buffer);
  const GLenum mode = m_objects.pipelines.get(state.pipeline).topology();
  const auto* offset = reinterpret_cast<const void*>(args.offset);
  const auto count = GLsizei(args.drawCount), stride = GLsizei(args.stride);
  if (indexed)
    gl.MultiDrawElementsIndirect(
        mode, state.indexType == rhi::IndexType::Uint16 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
        offset, count, stride);
  else
    gl.MultiDrawArraysIndirect(mode, offset, count, stride);
}

void CommandList::doDispatch(const rhi::DispatchState& state, uint32_t x, uint32_t y, uint32_t z) {
  const Functions& gl = m_context.use();
  m_state.applyDispatch(state);
  gl.DispatchCompute(x, y, z);
}

void CommandList::doDispatchIndirect(const rhi::DispatchState& state, rhi::BufferId args,
                                     uint64_t offset) {
  const Functions& gl = m_context.use();
  m_state.applyDispatch(state);
  m_state.bindIndirect(GL_DISPATCH_INDIRECT_BUFFER, args);
  gl.DispatchComputeIndirect(GLintptr(offset));
}

void CommandList::doWrite(rhi::BufferId buffer, uint64_t offset, std::span<const std::byte> bytes) {
  m_context.use();
  m_barriers.before(GL_BUFFER_UPDATE_BARRIER_BIT);
  m_objects.buffers.get(buffer).write(offset, bytes);
}

void CommandList::doFill(rhi::BufferId buffer, uint64_t offset, uint64_t size, uint32_t word) {
  m_context.use();
  m_barriers.before(GL_BUFFER_UPDATE_BARRIER_BIT);
  Buffer& target = m_objects.buffers.get(buffer);
  target.fill(offset, target.sizeFrom(offset, size), word);
}

void CommandList::doCopy(rhi::BufferId source, uint64_t sourceOffset, rhi::BufferId target,
                         uint64_t targetOffset, uint64_t size) {
  const Functions& gl = m_context.use();
  m_barriers.before(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl.CopyNamedBufferSubData(m_objects.buffers.get(source).name(),
                            m_objects.buffers.get(target).name(), GLintptr(sourceOffset),
                            GLintptr(targetOffset), GLsizeiptr(size));
}

void CommandList::doCopy(const rhi::TextureView& source, const rhi::TextureView& target) {
  const Functions& gl = m_context.use();
  m_barriers.before(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
  const Texture& from = m_objects.textures.get(source.texture);
  const Texture& to = m_objects.textures.get(target.texture);
  const ViewRange a = from.resolve(source), b = to.resolve(target);
  const bool volume = from.desc().kind == rhi::TextureKind::Tex3D;
  for (uint32_t i = 0; i < a.mipCount; ++i) {
    const uint32_t mip = a.baseMip + i;
    const rhi::Extent2D extent = from.extent(mip);
    const uint32_t depth = volume ? from.layers(mip) : a.layerCount;
    gl.CopyImageSubData(from.name(), from.target(), GLint(mip), 0, 0,
                        volume ? 0 : GLint(a.baseLayer), to.name(), to.target(),
                        GLint(b.baseMip + i), 0, 0, volume ? 0 : GLint(b.baseLayer),
                        GLsizei(extent.width), GLsizei(extent.height), GLsizei(depth));
  }
}

void CommandList::doTimestamp(rhi::QueryPoolId pool, uint32_t index) {
  m_context.use();
  m_objects.queryPools.get(pool).timestamp(index);
}

void CommandList::doBeginQuery(rhi::QueryPoolId pool, uint32_t index) {
  m_context.use();
  m_objects.queryPools.get(pool).begin(index);
  m_query = pool;
  m_queryIndex = index;
}

void CommandList::doEndQuery(rhi::QueryPoolId pool, uint32_t index) {
  m_context.use();
  m_objects.queryPools.get(pool).end(index);
  m_query = {};
}

}  // namespace opengl
