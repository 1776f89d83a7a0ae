#include "backends/opengl/commands/gl_barriers.h"

#include <algorithm>

namespace opengl {
namespace {

constexpr GLbitfield kStorageBits =
    GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;

GLbitfield accessBit(const rhi::ResourceUse& use) {
  switch (use.access) {
    case rhi::Access::Uniform:
      return GL_UNIFORM_BARRIER_BIT;
    case rhi::Access::Vertex:
      return GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT;
    case rhi::Access::Index:
      return GL_ELEMENT_ARRAY_BARRIER_BIT;
    case rhi::Access::Indirect:
      return GL_COMMAND_BARRIER_BIT;
    case rhi::Access::Sampled:
      return GL_TEXTURE_FETCH_BARRIER_BIT;
    case rhi::Access::StorageRead:
    case rhi::Access::StorageWrite:
      return use.buffer ? GL_SHADER_STORAGE_BARRIER_BIT : GL_SHADER_IMAGE_ACCESS_BARRIER_BIT;
  }
  return 0;
}

bool stores(const rhi::PassDesc& pass) {
  return std::ranges::any_of(pass.writes, [](const rhi::ResourceUse& use) {
    return use.access == rhi::Access::StorageWrite;
  });
}

}  // namespace

void Barriers::before(GLbitfield bits) {
  if (const GLbitfield needed = bits & m_stale) {
    m_gl.MemoryBarrier(needed);
    m_stale &= ~needed;
  }
}

void Barriers::beginPass(const rhi::PassDesc& pass) {
  m_storing = stores(pass);
  GLbitfield bits = 0;
  for (const rhi::ResourceUse& use : pass.reads) bits |= accessBit(use);
  for (const rhi::ResourceUse& use : pass.writes) bits |= accessBit(use);
  if (!pass.colors.empty() || pass.depth) bits |= GL_FRAMEBUFFER_BARRIER_BIT;
  // Stores must not overtake the reads of earlier passes either (write after read). Those reads
  // need no declaration where uploads wrote the data, so any earlier pass may have made one.
  if (m_storing) {
    if (m_passSinceBarrier) m_stale |= kStorageBits;
    bits |= kStorageBits;
    m_passSinceBarrier = false;
  }
  before(bits);
  // Sampling what is attached is defined for read-only depth, once earlier writes are flushed.
  if (pass.depth && pass.depth->readOnly &&
      std::ranges::any_of(pass.reads, [&](const rhi::ResourceUse& use) {
        return use.view.texture == pass.depth->view.texture;
      }))
    m_gl.TextureBarrier();
}

void Barriers::endPass() {
  if (m_storing) m_stale = ~GLbitfield(0);
  m_passSinceBarrier = true;
}

}  // namespace opengl
