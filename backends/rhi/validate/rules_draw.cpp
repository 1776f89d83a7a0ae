// Rules about the pipeline, the buffers and the arguments of a draw or dispatch.
#include <algorithm>

#include "backends/rhi/validate/rules.h"

namespace rhi::validate {

const Binding* DrawCheck::at(uint32_t slot) const {
  const Binding* found = nullptr;
  for (const Binding& binding : bindings)
    if (binding.slot == slot) found = &binding;
  return found;
}

std::string DrawCheck::where() const {
  return "pass '" + pass->label + "', pipeline '" + (pipeline ? pipeline->label : "?") + "': ";
}

namespace {

void pipelineKind(const DrawCheck& c, const Emit& emit) {
  if (!c.pipeline) {
    emit(c.where() + "the pipeline does not exist");
    return;
  }
  if (c.pipeline->compute != !c.draw)
    emit(c.where() +
         (c.draw ? "a draw needs a graphics pipeline" : "a dispatch needs a compute pipeline"));
  if (c.pass->compute != !c.draw)
    emit(c.where() + (c.draw ? "a draw in a compute pass" : "a dispatch in a graphics pass"));
}

void pipelineAttachments(const DrawCheck& c, const Emit& emit) {
  if (!c.pipeline || !c.draw || c.pipeline->compute || c.pass->compute) return;
  const auto& colors = c.pass->colors;
  if (colors.size() != c.pipeline->targets.size()) {
    emit(c.where() + "the pass has " + std::to_string(colors.size()) +
         " colour attachments, the pipeline " + std::to_string(c.pipeline->targets.size()) +
         " `targets`");
    return;
  }
  auto check = [&](const TextureView& view, Format expected, const std::string& field) {
    const TextureInfo* texture = c.state->find(view.texture);
    if (!texture) return;
    if (texture->desc.format != expected)
      emit(c.where() + field + " is " + std::string(formatInfo(texture->desc.format).name) +
           ", the pipeline was made for " + std::string(formatInfo(expected).name));
    if (texture->desc.samples != c.pipeline->samples)
      emit(c.where() + field + " has " + std::to_string(texture->desc.samples) +
           " samples, the pipeline " + std::to_string(c.pipeline->samples));
  };
  for (size_t i = 0; i < colors.size(); ++i)
    check(colors[i].view, c.pipeline->targets[i], "colors[" + std::to_string(i) + "]");
  if (c.pass->depth)
    check(c.pass->depth->view, c.pipeline->depthFormat, "depth");
  else if (c.pipeline->depthFormat != Format::Undefined)
    emit(c.where() + "the pipeline has a `depthFormat`, the pass no depth");
}

void depthReadOnly(const DrawCheck& c, const Emit& emit) {
  if (!c.pipeline || !c.draw || !c.pass->depth) return;
  if (c.pass->depth->readOnly && c.pipeline->writesDepth)
    emit(c.where() + "the pipeline writes depth, which the pass attaches read-only");
  if (c.pass->depth->stencilReadOnly && c.pipeline->writesStencil)
    emit(c.where() + "the pipeline writes stencil, which the pass attaches read-only");
}

uint64_t formatBytes(VertexFormat format) {
  static constexpr uint64_t kBytes[] = {4, 8, 12, 16, 4, 8, 16, 4};
  return kBytes[size_t(format)];
}

void vertexBuffers(const DrawCheck& c, const Emit& emit) {
  if (!c.pipeline || !c.draw) return;
  const size_t needed = c.pipeline->vertexBuffers.size();
  if (c.draw->vertexBuffers.size() < needed)
    emit(c.where() + "the pipeline needs " + std::to_string(needed) +
         " vertexBuffers, the draw has " + std::to_string(c.draw->vertexBuffers.size()));
  for (size_t i = 0; i < std::min(needed, c.draw->vertexBuffers.size()); ++i) {
    const BufferInfo* buffer = c.state->find(c.draw->vertexBuffers[i].buffer);
    const std::string field = "vertexBuffers[" + std::to_string(i) + "]";
    if (!buffer)
      emit(c.where() + field + " does not exist");
    else if (!has(buffer->desc.use, BufferUse::Vertex))
      emit(c.where() + field + " is buffer '" + buffer->desc.label + "' without BufferUse::Vertex");
  }
}

void indexBuffer(const DrawCheck& c, const Emit& emit) {
  if (!c.draw || !c.usesIndices) return;
  const BufferInfo* buffer = c.state->find(c.draw->indexBuffer);
  if (!buffer)
    emit(c.where() + "an indexed draw without an indexBuffer");
  else if (!has(buffer->desc.use, BufferUse::Index))
    emit(c.where() + "indexBuffer is buffer '" + buffer->desc.label + "' without BufferUse::Index");
}

void vertexRange(const DrawCheck& c, const Emit& emit) {
  if (!c.pipeline || !c.draw || (!c.direct && !c.indexed)) return;
  const uint64_t instances = c.direct
                                 ? c.direct->instanceCount
                                 : uint64_t(c.indexed->firstInstance) + c.indexed->instanceCount;
  for (const VertexAttribute& a : c.pipeline->attributes) {
    if (a.buffer >= c.pipeline->vertexBuffers.size() || a.buffer >= c.draw->vertexBuffers.size())
      continue;
    const VertexBufferLayout& layout = c.pipeline->vertexBuffers[a.buffer];
    const VertexBufferBinding& bound = c.draw->vertexBuffers[a.buffer];
    const BufferInfo* buffer = c.state->find(bound.buffer);
    // Which vertices an indexed draw reads is in the indices, which are not looked at.
    const uint64_t count = layout.perInstance ? instances
                           : c.direct ? uint64_t(c.direct->firstVertex) + c.direct->vertexCount
                                      : 0;
    if (!buffer || count == 0) continue;
    const uint64_t end =
        bound.offset + (count - 1) * layout.stride + a.offset + formatBytes(a.format);
    if (end > buffer->desc.size)
      emit(c.where() + "attribute " + std::to_string(a.location) + " reads up to byte " +
           std::to_string(end) + " of buffer '" + buffer->desc.label + "' with " +
           std::to_string(buffer->desc.size));
  }
}

void indexRange(const DrawCheck& c, const Emit& emit) {
  if (!c.draw || !c.indexed) return;
  const BufferInfo* buffer = c.state->find(c.draw->indexBuffer);
  const uint64_t bytes = c.draw->indexType == IndexType::Uint16 ? 2 : 4;
  const uint64_t end =
      c.draw->indexOffset + (uint64_t(c.indexed->firstIndex) + c.indexed->indexCount) * bytes;
  if (buffer && end > buffer->desc.size)
    emit(c.where() + "indices reach to byte " + std::to_string(end) + " of buffer '" +
         buffer->desc.label + "' with " + std::to_string(buffer->desc.size));
  if (c.draw->indexOffset % bytes != 0)
    emit(c.where() + "indexOffset is not a multiple of an index");
}

void indirectRange(const DrawCheck& c, const Emit& emit) {
  if (!c.indirect) return;
  const BufferInfo* buffer = c.state->find(c.indirect->buffer);
  if (!buffer) {
    emit(c.where() + "the buffer of the arguments does not exist");
    return;
  }
  if (!has(buffer->desc.use, BufferUse::Indirect))
    emit(c.where() + "buffer '" + buffer->desc.label + "' lacks BufferUse::Indirect");
  const uint64_t bytes = !c.draw ? 12 : c.usesIndices ? 20 : 16;
  const uint64_t stride = c.indirect->stride ? c.indirect->stride : bytes;
  if (c.indirect->offset % 4 != 0 || stride % 4 != 0 || stride < bytes)
    emit(c.where() +
         "offset and stride of arguments are multiples of 4, and a stride holds a draw");
  const uint64_t count = c.indirect->drawCount;
  if (count > 0 && c.indirect->offset + (count - 1) * stride + bytes > buffer->desc.size)
    emit(c.where() + "the arguments reach outside buffer '" + buffer->desc.label + "'");
}

constexpr Rule<DrawCheck> kRules[] = {
    {"pipeline-kind", pipelineKind},    {"pipeline-attachments", pipelineAttachments},
    {"depth-read-only", depthReadOnly}, {"vertex-buffers", vertexBuffers},
    {"index-buffer", indexBuffer},      {"vertex-range", vertexRange},
    {"index-range", indexRange},        {"indirect-range", indirectRange},
};

}  // namespace

std::span<const Rule<DrawCheck>> drawRules() { return kRules; }

}  // namespace rhi::validate
