#include "backends/opengl/resources/gl_buffer.h"

#include <cassert>

#include "backends/opengl/device/gl_debug.h"

namespace opengl {

Buffer::Buffer(const Functions& gl, const rhi::BufferDesc& desc) : m_gl(&gl), m_desc(desc) {
  clearErrors(gl);
  GLuint name = 0;
  gl.CreateBuffers(1, &name);
  m_name = UniqueName(gl, name, [](const Functions& f, GLuint n) { f.DeleteBuffers(1, &n); });
  gl.NamedBufferStorage(name, GLsizeiptr(desc.size), nullptr, GL_DYNAMIC_STORAGE_BIT);
  throwOnError(gl, "glNamedBufferStorage",
               "buffer '" + desc.label + "' of " + std::to_string(desc.size) + " bytes");
  labelObject(gl, GL_BUFFER, name, desc.label);
}

uint64_t Buffer::sizeFrom(uint64_t offset, uint64_t size) const {
  return size == rhi::kWholeSize ? m_desc.size - offset : size;
}

void Buffer::write(uint64_t offset, std::span<const std::byte> bytes) {
  assert(offset + bytes.size() <= m_desc.size);
  m_gl->NamedBufferSubData(name(), GLintptr(offset), GLsizeiptr(bytes.size()), bytes.data());
}

void Buffer::read(uint64_t offset, std::span<std::byte> out) const {
  assert(offset + out.size() <= m_desc.size);
  m_gl->GetNamedBufferSubData(name(), GLintptr(offset), GLsizeiptr(out.size()), out.data());
}

void Buffer::fill(uint64_t offset, uint64_t size, uint32_t word) {
  m_gl->ClearNamedBufferSubData(name(), GL_R32UI, GLintptr(offset), GLsizeiptr(size),
                                GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
}

}  // namespace opengl
