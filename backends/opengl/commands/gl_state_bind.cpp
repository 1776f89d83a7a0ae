// The part of State that binds resources: slots, vertex and index buffers.
#include <algorithm>
#include <cassert>

#include "backends/opengl/commands/gl_state.h"
#include "backends/opengl/resources/gl_formats.h"
#include "backends/rhi/memory_limit.h"

namespace opengl {

void State::applyVertexInput(const Pipeline& pipeline, const rhi::DrawState& draw, bool indexed) {
  const VertexInput& input = pipeline.vertexInput();
  if (m_inputPipeline != draw.pipeline) {
    setVertexFormats(input);
    m_inputPipeline = draw.pipeline;
    m_vertexBuffers.fill({});  // strides are set with the buffers
  }
  assert(draw.vertexBuffers.size() >= input.buffers.size());
  for (GLuint i = 0; i < input.buffers.size(); ++i) {
    const VertexSource source{draw.vertexBuffers[i].buffer, draw.vertexBuffers[i].offset};
    if (source == m_vertexBuffers[i]) continue;
    m_gl.BindVertexBuffer(i, m_objects.buffers.get(source.buffer).name(), GLintptr(source.offset),
                          GLsizei(input.buffers[i].stride));
    m_vertexBuffers[i] = source;
  }
  if (indexed && draw.indexBuffer != m_indexBuffer) {
    m_gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_objects.buffers.get(draw.indexBuffer).name());
    m_indexBuffer = draw.indexBuffer;
  }
}

void State::setVertexFormats(const VertexInput& input) {
  std::array<bool, 16> wanted{};
  for (const rhi::VertexAttribute& attribute : input.attributes) {
    const VertexFormatInfo format = vertexFormat(attribute.format);
    wanted[attribute.location] = true;
    if (format.integer)
      m_gl.VertexAttribIFormat(attribute.location, format.components, format.type,
                               attribute.offset);
    else
      m_gl.VertexAttribFormat(attribute.location, format.components, format.type,
                              GLboolean(format.normalized), attribute.offset);
    m_gl.VertexAttribBinding(attribute.location, attribute.buffer);
  }
  for (GLuint i = 0; i < wanted.size(); ++i) {
    if (wanted[i] == m_attributeOn[i]) continue;
    (wanted[i] ? m_gl.EnableVertexAttribArray : m_gl.DisableVertexAttribArray)(i);
    m_attributeOn[i] = wanted[i];
  }
  for (GLuint i = 0; i < input.buffers.size(); ++i)
    m_gl.VertexBindingDivisor(i, input.buffers[i].perInstance ? 1 : 0);
}

void State::applyBindings(std::span<const rhi::Binding> bindings, uint64_t slots) {
  for (const rhi::Binding& binding : bindings) {
    assert(binding.slot < rhi::kSlotCount);
    if (!(slots >> binding.slot & 1) || binding == m_bound[binding.slot]) continue;
    bind(binding);
    m_bound[binding.slot] = binding;
  }
}

void State::bind(const rhi::Binding& b) {
  if (b.slot < rhi::kTextureSlotBase) {
    const bool uniform = b.slot < rhi::kStorageSlotBase;
    const Buffer& buffer = m_objects.buffers.get(b.buffer);
    if (!uniform)
      rhi::requireStorageRange(m_limits, buffer.desc().label, buffer.sizeFrom(b.offset, b.size));
    m_gl.BindBufferRange(uniform ? GL_UNIFORM_BUFFER : GL_SHADER_STORAGE_BUFFER,
                         b.slot - (uniform ? rhi::kUniformSlotBase : rhi::kStorageSlotBase),
                         buffer.name(), GLintptr(b.offset),
                         GLsizeiptr(buffer.sizeFrom(b.offset, b.size)));
    return;
  }
  Texture& texture = m_objects.textures.get(b.view.texture);
  const ViewRange range = texture.resolve(b.view);
  if (b.slot < rhi::kImageSlotBase) {
    const GLuint unit = b.slot - rhi::kTextureSlotBase;
    m_gl.BindTextureUnit(unit, texture.viewName(range));
    // texelFetch and multisampled textures need no sampler.
    m_gl.BindSampler(unit, b.sampler ? m_objects.samplers.get(b.sampler).name() : 0);
    return;
  }
  // An image unit takes a level but only one or all layers: ranges of layers go through a view.
  const bool allLayers = !texture.isArray() || range.layerCount == texture.layers(range.baseMip);
  const GLuint name =
      allLayers ? texture.name()
                : texture.viewName({0, texture.desc().mips, range.baseLayer, range.layerCount});
  m_gl.BindImageTexture(b.slot - rhi::kImageSlotBase, name, GLint(range.baseMip),
                        GLboolean(texture.isArray()), 0, GL_READ_WRITE,
                        formatTriple(texture.desc().format).internalFormat);
}

}  // namespace opengl
