// Rules about the resources that a pipeline's shaders use in a draw or dispatch.
#include <algorithm>

#include "backends/rhi/validate/rules.h"

namespace rhi::validate {
namespace {

using Kind = ShaderResourceKind;

/// Every resource that the shaders use and that is bound.
template <class F>
void eachBound(const DrawCheck& c, F&& visit) {
  if (!c.pipeline) return;
  for (const ShaderResource& resource : c.pipeline->resources)
    if (const Binding* binding = c.at(resource.slot)) visit(resource, *binding);
}

bool isBuffer(Kind kind) { return kind == Kind::UniformBuffer || kind == Kind::StorageBuffer; }

std::string slotName(const ShaderResource& resource) {
  return "slot " + std::to_string(resource.slot) + " (" + resource.name + ")";
}

std::string bufferName(const BufferInfo& buffer) { return "buffer '" + buffer.desc.label + "'"; }

void missingBinding(const DrawCheck& c, const Emit& emit) {
  if (!c.pipeline) return;
  for (const ShaderResource& resource : c.pipeline->resources)
    if (!c.at(resource.slot)) emit(c.where() + slotName(resource) + " is not bound");
}

void bindingKind(const DrawCheck& c, const Emit& emit) {
  eachBound(c, [&](const ShaderResource& r, const Binding& b) {
    if (isBuffer(r.kind) ? !c.state->find(b.buffer) : !c.state->find(b.view.texture))
      emit(c.where() + slotName(r) + " needs a living " +
           (isBuffer(r.kind) ? "buffer" : "texture"));
    if (r.kind == Kind::Texture && !c.state->samplers.contains(b.sampler.value))
      emit(c.where() + slotName(r) + " needs a sampler");
  });
}

void bindingFlag(const DrawCheck& c, const Emit& emit) {
  eachBound(c, [&](const ShaderResource& r, const Binding& b) {
    if (const BufferInfo* buffer = c.state->find(b.buffer); buffer && isBuffer(r.kind)) {
      const BufferUse needs =
          r.kind == Kind::UniformBuffer ? BufferUse::Uniform : BufferUse::Storage;
      if (!has(buffer->desc.use, needs))
        emit(c.where() + slotName(r) + ": the `use` of " + bufferName(*buffer) +
             " does not allow that");
    }
    if (const TextureInfo* texture = c.state->find(b.view.texture); texture && !isBuffer(r.kind)) {
      const TextureUse needs = r.kind == Kind::Texture ? TextureUse::Sampled : TextureUse::Storage;
      if (!has(texture->desc.use, needs))
        emit(c.where() + slotName(r) + ": the `use` of texture '" + texture->desc.label +
             "' does not allow that");
    }
  });
}

void bindingAlignment(const DrawCheck& c, const Emit& emit) {
  const Limits& limits = c.state->info->limits;
  eachBound(c, [&](const ShaderResource& r, const Binding& b) {
    if (!isBuffer(r.kind)) return;
    const uint32_t alignment =
        r.kind == Kind::UniformBuffer ? limits.uniformAlignment : limits.storageAlignment;
    if (b.offset % alignment != 0)
      emit(c.where() + slotName(r) + ": offset " + std::to_string(b.offset) +
           " is not a multiple of " + std::to_string(alignment));
  });
}

void bindingRange(const DrawCheck& c, const Emit& emit) {
  const Limits& limits = c.state->info->limits;
  eachBound(c, [&](const ShaderResource& r, const Binding& b) {
    if (const BufferInfo* buffer = c.state->find(b.buffer); buffer && isBuffer(r.kind)) {
      const uint64_t size = buffer->desc.size;
      const bool whole = b.size == kWholeSize;
      if (b.offset >= size || (!whole && (b.size == 0 || b.size > size - b.offset)))
        emit(c.where() + slotName(r) + ": offset and size reach outside " + bufferName(*buffer));
      const uint64_t limit =
          r.kind == Kind::UniformBuffer ? limits.maxUniformRange : limits.maxStorageRange;
      const uint64_t range = whole ? size - std::min(size, b.offset) : b.size;
      // The whole of a uniform buffer is cut to what the device allows.
      if (range > limit && !(whole && r.kind == Kind::UniformBuffer))
        emit(c.where() + slotName(r) + ": " + std::to_string(range) + " bytes of " +
             bufferName(*buffer) + " exceed the device's " + std::to_string(limit));
    }
    const TextureInfo* texture = c.state->find(b.view.texture);
    if (texture && !isBuffer(r.kind) && !texture->contains(texture->range(b.view)))
      emit(c.where() + slotName(r) + ": the view reaches outside texture '" + texture->desc.label +
           "'");
  });
}

bool declared(const DrawCheck& c, BufferId buffer, Access access) {
  auto matches = [&](const ResourceUse& use) {
    return use.buffer == buffer && (use.access == access || (use.access == Access::StorageWrite &&
                                                             access == Access::StorageRead));
  };
  return std::ranges::any_of(c.pass->reads, matches) ||
         std::ranges::any_of(c.pass->writes, matches);
}

/// Whether uses of that access cover one mip and layer.
bool declared(const DrawCheck& c, const TextureView& part, Access access) {
  auto matches = [&](const ResourceUse& use) {
    return use.view.texture && overlap(*c.state, use.view, part) &&
           (use.access == access ||
            (use.access == Access::StorageWrite && access == Access::StorageRead));
  };
  return std::ranges::any_of(c.pass->reads, matches) ||
         std::ranges::any_of(c.pass->writes, matches);
}

/// First undeclared part of the view that a pass wrote (or any part if `always`).
const Content* undeclaredPart(const DrawCheck& c, const TextureInfo& texture,
                              const TextureView& view, Access access, bool always) {
  const Range range = texture.range(view);
  if (!texture.contains(range)) return nullptr;
  for (uint32_t layer = range.baseLayer; layer < range.layerEnd; ++layer)
    for (uint32_t mip = range.baseMip; mip < range.mipEnd; ++mip) {
      const Content& content = texture.contents[layer * texture.desc.mips + mip];
      if ((content.byPass || always) && !declared(c, {view.texture, mip, 1, layer, 1}, access))
        return &content;
    }
  return nullptr;
}

void checkBufferRead(const DrawCheck& c, BufferId id, Access access, const std::string& field,
                     const Emit& emit) {
  const BufferInfo* buffer = c.state->find(id);
  if (buffer && buffer->content.byPass && !declared(c, id, access))
    emit(c.where() + field + " reads " + bufferName(*buffer) + ", which pass '" +
         buffer->content.writer + "' wrote; the pass does not declare that read");
}

void undeclaredRead(const DrawCheck& c, const Emit& emit) {
  eachBound(c, [&](const ShaderResource& r, const Binding& b) {
    if (r.kind == Kind::UniformBuffer)
      checkBufferRead(c, b.buffer, Access::Uniform, slotName(r), emit);
    if (r.kind == Kind::StorageBuffer && r.readOnly)
      checkBufferRead(c, b.buffer, Access::StorageRead, slotName(r), emit);
    const TextureInfo* texture = c.state->find(b.view.texture);
    if (!texture || isBuffer(r.kind) || !r.readOnly) return;
    const Access access = r.kind == Kind::Texture ? Access::Sampled : Access::StorageRead;
    if (const Content* part = undeclaredPart(c, *texture, b.view, access, false))
      emit(c.where() + slotName(r) + " reads texture '" + texture->desc.label + "', which pass '" +
           part->writer + "' wrote; the pass does not declare that read");
  });
  if (c.draw) {
    for (size_t i = 0; i < c.draw->vertexBuffers.size(); ++i)
      checkBufferRead(c, c.draw->vertexBuffers[i].buffer, Access::Vertex,
                      "vertexBuffers[" + std::to_string(i) + "]", emit);
    if (c.usesIndices) checkBufferRead(c, c.draw->indexBuffer, Access::Index, "indexBuffer", emit);
  }
  if (c.indirect) checkBufferRead(c, c.indirect->buffer, Access::Indirect, "arguments", emit);
}

void undeclaredWrite(const DrawCheck& c, const Emit& emit) {
  eachBound(c, [&](const ShaderResource& r, const Binding& b) {
    if (r.readOnly) return;
    const BufferInfo* buffer = c.state->find(b.buffer);
    if (r.kind == Kind::StorageBuffer && buffer && !declared(c, b.buffer, Access::StorageWrite))
      emit(c.where() + slotName(r) + " may write " + bufferName(*buffer) +
           ", which the pass does not declare in writes");
    const TextureInfo* texture = c.state->find(b.view.texture);
    if (r.kind == Kind::Image && texture &&
        undeclaredPart(c, *texture, b.view, Access::StorageWrite, true))
      emit(c.where() + slotName(r) + " may write texture '" + texture->desc.label +
           "', which the pass does not declare in writes");
  });
}

void boundAttachment(const DrawCheck& c, const Emit& emit) {
  eachBound(c, [&](const ShaderResource& r, const Binding& b) {
    if (isBuffer(r.kind) || !c.state->find(b.view.texture)) return;
    auto check = [&](const TextureView& view, const std::string& field) {
      if (overlap(*c.state, view, b.view))
        emit(c.where() + slotName(r) + " is " + describe(*c.state, view.texture) +
             ", which is attached for writing as " + field);
    };
    for (size_t i = 0; i < c.pass->colors.size(); ++i) {
      check(c.pass->colors[i].view, "colors[" + std::to_string(i) + "]");
      if (c.pass->colors[i].resolve) check(*c.pass->colors[i].resolve, "a resolve target");
    }
    if (c.pass->depth && (!c.pass->depth->readOnly || r.kind == Kind::Image))
      check(c.pass->depth->view, "depth");
  });
}

constexpr Rule<DrawCheck> kRules[] = {
    {"missing-binding", missingBinding},   {"binding-kind", bindingKind},
    {"binding-flag", bindingFlag},         {"binding-alignment", bindingAlignment},
    {"binding-range", bindingRange},       {"undeclared-read", undeclaredRead},
    {"undeclared-write", undeclaredWrite}, {"bound-attachment", boundAttachment},
};

}  // namespace

std::span<const Rule<DrawCheck>> bindingRules() { return kRules; }

}  // namespace rhi::validate
