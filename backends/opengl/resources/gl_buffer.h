// A buffer: immutable storage in the driver's memory, filled through glNamedBufferSubData.
#pragma once

#include <cstddef>
#include <span>

#include "backends/opengl/resources/gl_object.h"
#include "backends/rhi/desc.h"

namespace opengl {

class Buffer {
 public:
  /// Throws rhi::Error (GL_OUT_OF_MEMORY, say) with the label.
  Buffer(const Functions& gl, const rhi::BufferDesc& desc);

  const rhi::BufferDesc& desc() const { return m_desc; }
  GLuint name() const { return m_name.get(); }
  /// kWholeSize resolved.
  uint64_t sizeFrom(uint64_t offset, uint64_t size) const;

  void write(uint64_t offset, std::span<const std::byte> bytes);
  void read(uint64_t offset, std::span<std::byte> out) const;
  void fill(uint64_t offset, uint64_t size, uint32_t word);

 private:
  const Functions* m_gl;
  rhi::BufferDesc m_desc;
  UniqueName m_name;
};

}  // namespace opengl
