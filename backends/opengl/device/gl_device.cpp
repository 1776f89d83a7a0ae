#include "backends/opengl/device/gl_device.h"

#include "backends/opengl/device/gl_debug.h"
#include "backends/opengl/device/gl_device_info.h"

namespace opengl {

Device::Device(std::unique_ptr<Context> context, rhi::DeviceInfo info, bool validate)
    : m_context(std::move(context)),
      m_state(m_context->use(), m_objects, info.limits),
      m_framebuffers(m_context->functions(), m_objects),
      m_barriers(m_context->functions()),
      m_commands(*m_context, m_objects, m_state, m_framebuffers, m_barriers) {
  m_info = std::move(info);
  if (validate) enableDebugOutput(m_context->functions(), *this);
}

Device::~Device() {
  Device::doWaitIdle();
  // Messages of the teardown would reach a half-destroyed object.
  m_context->use().Disable(GL_DEBUG_OUTPUT);
}

rhi::FormatCaps Device::formatCaps(rhi::Format format) const {
  return queryFormatCaps(m_context->use(), format);
}
const rhi::BufferDesc& Device::bufferDesc(rhi::BufferId id) const {
  return m_objects.buffers.get(id).desc();
}
const rhi::TextureDesc& Device::textureDesc(rhi::TextureId id) const {
  return m_objects.textures.get(id).desc();
}
const rhi::QueryPoolDesc& Device::queryPoolDesc(rhi::QueryPoolId id) const {
  return m_objects.queryPools.get(id).desc();
}

rhi::BufferId Device::doCreate(const rhi::BufferDesc& desc) {
  return m_objects.buffers.add(Buffer(m_context->use(), desc));
}
rhi::TextureId Device::doCreate(const rhi::TextureDesc& desc) {
  return m_objects.textures.add(Texture(m_context->use(), desc));
}
rhi::SamplerId Device::doCreate(const rhi::SamplerDesc& desc) {
  return m_objects.samplers.add(Sampler(m_context->use(), desc));
}
rhi::PipelineId Device::doCreate(const rhi::GraphicsPipelineDesc& desc) {
  return m_objects.pipelines.add(Pipeline(m_context->use(), desc));
}
rhi::PipelineId Device::doCreate(const rhi::ComputePipelineDesc& desc) {
  return m_objects.pipelines.add(Pipeline(m_context->use(), desc));
}
rhi::QueryPoolId Device::doCreate(const rhi::QueryPoolDesc& desc) {
  return m_objects.queryPools.add(QueryPool(m_context->use(), desc, isSoftware()));
}

// OpenGL itself keeps what queued commands still use.
void Device::doDestroy(rhi::BufferId id) {
  m_context->use();
  m_objects.buffers.remove(id);
  m_state.forgetBindings();
}
void Device::doDestroy(rhi::TextureId id) {
  m_context->use();
  for (GLuint framebuffer : m_framebuffers.forget(id)) m_state.forgetFramebuffer(framebuffer);
  m_objects.textures.remove(id);
  m_state.forgetBindings();
}
void Device::doDestroy(rhi::SamplerId id) {
  m_context->use();
  m_objects.samplers.remove(id);
  m_state.forgetBindings();
}
void Device::doDestroy(rhi::PipelineId id) {
  m_context->use();
  m_state.forgetBindings();
  m_objects.pipelines.remove(id);
}
void Device::doDestroy(rhi::QueryPoolId id) {
  m_context->use();
  m_objects.queryPools.remove(id);
}

void Device::doUpload(rhi::BufferId buffer, uint64_t offset, std::span<const std::byte> bytes) {
  m_context->use();
  m_barriers.before(GL_BUFFER_UPDATE_BARRIER_BIT);
  m_objects.buffers.get(buffer).write(offset, bytes);
}

void Device::doUpload(rhi::TextureId texture, const rhi::TextureRegion& region,
                      std::span<const std::byte> bytes) {
  m_context->use();
  m_barriers.before(GL_TEXTURE_UPDATE_BARRIER_BIT);
  m_objects.textures.get(texture).upload(region, bytes);
}

void Device::doRead(rhi::BufferId buffer, uint64_t offset, std::span<std::byte> out) {
  m_context->use();
  m_barriers.before(GL_BUFFER_UPDATE_BARRIER_BIT);
  m_objects.buffers.get(buffer).read(offset, out);
}

void Device::doRead(rhi::TextureId texture, const rhi::TextureRegion& region, rhi::Aspect aspect,
                    std::span<std::byte> out) {
  m_context->use();
  m_barriers.before(GL_TEXTURE_UPDATE_BARRIER_BIT);
  m_objects.textures.get(texture).read(region, aspect, out);
}

rhi::CommandList& Device::doBeginFrame() {
  m_context->use();
  while (m_inFlight.size() >= rhi::kFramesInFlight) finishOldest();
  return m_commands;
}

rhi::Ticket Device::doEndFrame() {
  const Functions& gl = m_context->use();
  m_inFlight.push_back({++m_lastTicket, gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)});
  gl.Flush();  // or a driver may sit on the frame until somebody waits for it
  return m_lastTicket;
}

// Commands were executed as they came: only what is open is closed.
void Device::doAbandonFrame() {
  m_context->use();
  m_commands.abandon();
  m_state.forgetBindings();
}

void Device::finishOldest() {
  const Functions& gl = m_context->use();
  const Frame frame = m_inFlight.front();
  m_inFlight.pop_front();
  constexpr GLuint64 kSecond = 1'000'000'000;
  GLenum result = GL_TIMEOUT_EXPIRED;
  while (result == GL_TIMEOUT_EXPIRED)
    result = gl.ClientWaitSync(frame.fence, GL_SYNC_FLUSH_COMMANDS_BIT, kSecond);
  gl.DeleteSync(frame.fence);
  if (result == GL_WAIT_FAILED)
    throw rhi::Error("glClientWaitSync", errorName(gl.GetError()),
                     "frame " + std::to_string(frame.ticket) + " did not complete");
}

void Device::doWait(rhi::Ticket ticket) {
  m_context->use();
  while (!m_inFlight.empty() && m_inFlight.front().ticket <= ticket) finishOldest();
}

void Device::doWaitIdle() {
  const Functions& gl = m_context->use();
  gl.Finish();
  for (const Frame& frame : m_inFlight) gl.DeleteSync(frame.fence);
  m_inFlight.clear();
}

void Device::doReadQueries(rhi::QueryPoolId pool, uint32_t first, uint32_t count,
                           std::span<uint64_t> out) {
  m_context->use();
  m_objects.queryPools.get(pool).read(first, count, out);
}

}  // namespace opengl
