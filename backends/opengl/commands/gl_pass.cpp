// The part of CommandList that begins and ends passes: barriers, framebuffer, clears, resolves.
#include <algorithm>
#include <limits>

#include "backends/opengl/commands/gl_command_list.h"
#include "backends/opengl/device/gl_debug.h"

namespace opengl {

void CommandList::doBeginPass(const rhi::PassDesc& desc) {
  const Functions& gl = m_context.use();
  m_resolves.clear();
  m_discards.clear();
  const FramebufferKey key = m_framebuffers.key(desc);
  m_framebuffer = desc.compute ? 0 : m_framebuffers.get(key);  // may throw: nothing is begun yet
  pushGroup(gl, desc.label);
  m_grouped = true;
  m_barriers.beginPass(desc);
  if (desc.compute) return;

  m_state.beginPass(m_framebuffer, m_framebuffers.extent(key), desc.depth);
  clear(m_framebuffer, desc);

  for (size_t i = 0; i < desc.colors.size(); ++i) {
    const rhi::ColorAttachment& color = desc.colors[i];
    if (color.resolve) m_resolves.push_back({color.view, *color.resolve});
    if (color.store == rhi::StoreOp::DontCare)
      m_discards.push_back(GL_COLOR_ATTACHMENT0 + GLenum(i));
  }
  if (!desc.depth) return;
  if (desc.depth->store == rhi::StoreOp::DontCare && !desc.depth->readOnly)
    m_discards.push_back(GL_DEPTH_ATTACHMENT);
  if (hasStencil(*desc.depth) && desc.depth->stencilStore == rhi::StoreOp::DontCare &&
      !desc.depth->stencilReadOnly)
    m_discards.push_back(GL_STENCIL_ATTACHMENT);
}

bool CommandList::hasStencil(const rhi::DepthAttachment& depth) const {
  return rhi::formatInfo(m_objects.textures.get(depth.view.texture).desc().format).stencil;
}

void CommandList::clear(GLuint framebuffer, const rhi::PassDesc& desc) {
  const Functions& gl = m_context.functions();
  const bool depth = desc.depth && desc.depth->load == rhi::LoadOp::Clear;
  const bool stencil =
      desc.depth && hasStencil(*desc.depth) && desc.depth->stencilLoad == rhi::LoadOp::Clear;
  const bool any =
      depth || stencil || std::ranges::any_of(desc.colors, [](const rhi::ColorAttachment& c) {
        return c.load == rhi::LoadOp::Clear;
      });
  if (any) m_state.openMasks();
  for (size_t i = 0; i < desc.colors.size(); ++i) {
    const rhi::ColorAttachment& color = desc.colors[i];
    if (color.load != rhi::LoadOp::Clear) continue;
    const auto& c = color.clear;
    const rhi::Format format = m_objects.textures.get(color.view.texture).desc().format;
    switch (rhi::formatInfo(format).kind) {
      case rhi::FormatKind::Uint: {
        const GLuint value[] = {rhi::integerClear<GLuint>(c[0]), rhi::integerClear<GLuint>(c[1]),
                                rhi::integerClear<GLuint>(c[2]), rhi::integerClear<GLuint>(c[3])};
        gl.ClearNamedFramebufferuiv(framebuffer, GL_COLOR, GLint(i), value);
        break;
      }
      case rhi::FormatKind::Sint: {
        const GLint value[] = {rhi::integerClear<GLint>(c[0]), rhi::integerClear<GLint>(c[1]),
                               rhi::integerClear<GLint>(c[2]), rhi::integerClear<GLint>(c[3])};
        gl.ClearNamedFramebufferiv(framebuffer, GL_COLOR, GLint(i), value);
        break;
      }
      default:
        gl.ClearNamedFramebufferfv(framebuffer, GL_COLOR, GLint(i), c.data());
    }
  }
  if (depth && stencil) {
    gl.ClearNamedFramebufferfi(framebuffer, GL_DEPTH_STENCIL, 0, desc.depth->clearDepth,
                               GLint(desc.depth->clearStencil));
  } else if (depth) {
    gl.ClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &desc.depth->clearDepth);
  } else if (stencil) {
    const GLint value = desc.depth->clearStencil;
    gl.ClearNamedFramebufferiv(framebuffer, GL_STENCIL, 0, &value);
  }
}

void CommandList::resolve(const Resolve& resolve) {
  const Functions& gl = m_context.functions();
  const AttachmentKey from = m_framebuffers.attachment(resolve.source);
  const AttachmentKey to = m_framebuffers.attachment(resolve.target);
  const rhi::Extent2D extent = m_objects.textures.get(resolve.source.texture).extent(from.mip);
  const auto w = GLint(extent.width), h = GLint(extent.height);
  // A blit reads and writes the first layer of a layered attachment only.
  for (uint32_t layer = 0; layer < from.layerCount; ++layer) {
    const FramebufferKey source{.colors = {{from.texture, from.mip, from.baseLayer + layer, 1}}};
    const FramebufferKey target{.colors = {{to.texture, to.mip, to.baseLayer + layer, 1}}};
    gl.BlitNamedFramebuffer(m_framebuffers.get(source), m_framebuffers.get(target), 0, 0, w, h, 0,
                            0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
}

void CommandList::doEndPass() {
  const Functions& gl = m_context.use();
  if (!m_resolves.empty()) m_state.openMasks();
  for (const Resolve& r : m_resolves) resolve(r);
  if (!m_discards.empty())
    gl.InvalidateNamedFramebufferData(m_framebuffer, GLsizei(m_discards.size()), m_discards.data());
  m_barriers.endPass();
  popGroup(gl);
  m_grouped = false;
}

void CommandList::abandon() {
  const Functions& gl = m_context.use();
  if (m_query) m_objects.queryPools.get(m_query).end(m_queryIndex);
  m_query = {};
  if (m_grouped) {
    m_barriers.endPass();
    popGroup(gl);
  }
  m_grouped = false;
  m_resolves.clear();
  m_discards.clear();
}

}  // namespace opengl
