#include "backends/rhi/validate/state.h"

#include <algorithm>

namespace rhi::validate {
namespace {

template <class Map>
auto lookUp(const Map& map, uint32_t id) -> decltype(&map.begin()->second) {
  auto it = map.find(id);
  return it == map.end() ? nullptr : &it->second;
}

template <class F>
void change(State& state, const TextureView& view, F&& visit) {
  auto it = state.textures.find(view.texture.value);
  if (it == state.textures.end()) return;
  const Range range = it->second.range(view);
  if (it->second.contains(range)) it->second.each(range, visit);
}

void mark(State& state, const TextureView& view, const Content& content) {
  change(state, view, [&](Content& c) { c = content; });
}

void markDepth(State& state, const DepthAttachment& depth, const std::string& pass) {
  change(state, depth.view, [&](Content& c) {
    const bool stencil = depth.stencilReadOnly ? c.stencil : depth.stencilStore == StoreOp::Store;
    if (!depth.readOnly)
      c = {.written = depth.store == StoreOp::Store, .byPass = true, .writer = pass};
    c.stencil = stencil;
  });
}

}  // namespace

Range TextureInfo::range(const TextureView& view) const {
  auto end = [](uint32_t base, uint32_t count, uint32_t all) {
    return count == kAllRemaining ? std::max(base, all) : base + count;
  };
  return {view.baseMip, end(view.baseMip, view.mipCount, desc.mips), view.baseLayer,
          end(view.baseLayer, view.layerCount, desc.layers)};
}

bool TextureInfo::contains(const Range& r) const {
  return r.baseMip < r.mipEnd && r.mipEnd <= desc.mips && r.baseLayer < r.layerEnd &&
         r.layerEnd <= desc.layers;
}

const BufferInfo* State::find(BufferId id) const { return lookUp(buffers, id.value); }
const TextureInfo* State::find(TextureId id) const { return lookUp(textures, id.value); }
const PipelineInfo* State::find(PipelineId id) const { return lookUp(pipelines, id.value); }
const QueryPoolDesc* State::find(QueryPoolId id) const { return lookUp(pools, id.value); }

bool overlap(const State& state, const TextureView& a, const TextureView& b) {
  if (a.texture != b.texture) return false;
  const TextureInfo* texture = state.find(a.texture);
  if (!texture) return false;
  const Range x = texture->range(a), y = texture->range(b);
  return x.baseMip < y.mipEnd && y.baseMip < x.mipEnd && x.baseLayer < y.layerEnd &&
         y.baseLayer < x.layerEnd;
}

std::string describe(const State& state, BufferId id) {
  const BufferInfo* buffer = state.find(id);
  return buffer ? "buffer '" + buffer->desc.label + "'" : "a buffer that does not exist";
}

std::string describe(const State& state, TextureId id) {
  const TextureInfo* texture = state.find(id);
  return texture ? "texture '" + texture->desc.label + "'" : "a texture that does not exist";
}

void applyPass(State& state) {
  const ActivePass& pass = *state.pass;
  const Content stored = {.written = true, .byPass = true, .writer = pass.label};
  const Content lost = {.written = false, .byPass = true, .writer = pass.label};
  for (const ColorAttachment& color : pass.colors) {
    mark(state, color.view, color.store == StoreOp::Store ? stored : lost);
    if (color.resolve) mark(state, *color.resolve, stored);
  }
  if (pass.depth) markDepth(state, *pass.depth, pass.label);
  for (const ResourceUse& use : pass.writes) {
    if (use.buffer) {
      auto it = state.buffers.find(use.buffer.value);
      if (it != state.buffers.end()) it->second.content = stored;
    } else {
      mark(state, use.view, stored);
    }
  }
}

void markTransferred(State& state, BufferId id) {
  auto it = state.buffers.find(id.value);
  if (it != state.buffers.end()) it->second.content = {.written = true};
}

void markTransferred(State& state, const TextureView& view) {
  mark(state, view, {.written = true, .stencil = true});
}

void markDiscarded(State& state, TextureId id) {
  change(state, {.texture = id}, [](Content& c) { c.written = c.stencil = false; });
}

}  // namespace rhi::validate
