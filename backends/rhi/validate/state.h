// What the validator knows: every object, who wrote which part of it, the pass under way.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "backends/rhi/device.h"

namespace rhi::validate {

/// Contents of a buffer or of one mip and layer of a texture.
struct Content {
  bool written = false;  ///< holds something
  bool byPass = false;   ///< changed by a pass since the last transfer: must be declared
  std::string writer;    ///< label of that pass
  bool stencil = false;  ///< of a texture: its stencil holds something; the others speak of depth
};

struct BufferInfo {
  BufferDesc desc;
  Content content;
};

/// A TextureView with its counts resolved.
struct Range {
  uint32_t baseMip = 0, mipEnd = 0;
  uint32_t baseLayer = 0, layerEnd = 0;
};

struct TextureInfo {
  TextureDesc desc;
  std::vector<Content> contents;  ///< layer * mips + mip

  Range range(const TextureView& view) const;
  bool contains(const Range& range) const;
  template <class F>
  void each(const Range& range, F&& visit) {
    for (uint32_t layer = range.baseLayer; layer < range.layerEnd; ++layer)
      for (uint32_t mip = range.baseMip; mip < range.mipEnd; ++mip)
        visit(contents[layer * desc.mips + mip]);
  }
  template <class F>
  void each(const Range& range, F&& visit) const {
    const_cast<TextureInfo*>(this)->each(range, [&](Content& c) { visit(std::as_const(c)); });
  }
};

struct PipelineInfo {
  std::string label;
  bool compute = false;
  std::vector<ShaderResource> resources;  ///< of all stages, merged by slot
  std::vector<Format> targets;
  Format depthFormat = Format::Undefined;
  bool writesDepth = false;
  bool writesStencil = false;
  uint32_t samples = 1;
  std::vector<VertexBufferLayout> vertexBuffers;
  std::vector<VertexAttribute> attributes;
};

/// A PassDesc that owns its lists.
struct ActivePass {
  std::string label;
  bool compute = false;
  std::vector<ColorAttachment> colors;
  std::optional<DepthAttachment> depth;
  std::vector<ResourceUse> reads;
  std::vector<ResourceUse> writes;
  Extent2D extent;
};

struct State {
  const DeviceInfo* info = nullptr;
  std::map<uint32_t, BufferInfo> buffers;
  std::map<uint32_t, TextureInfo> textures;
  std::map<uint32_t, SamplerDesc> samplers;
  std::map<uint32_t, PipelineInfo> pipelines;
  std::map<uint32_t, QueryPoolDesc> pools;
  std::optional<ActivePass> pass;
  std::set<std::pair<uint32_t, uint32_t>> openQueries;  ///< pool, index
  std::set<std::pair<uint32_t, uint32_t>> usedQueries;  ///< in this frame

  const BufferInfo* find(BufferId id) const;
  const TextureInfo* find(TextureId id) const;
  const PipelineInfo* find(PipelineId id) const;
  const QueryPoolDesc* find(QueryPoolId id) const;
};

/// Same texture and a common mip and layer.
bool overlap(const State& state, const TextureView& a, const TextureView& b);
/// "texture 'shadow map'", "buffer 'nodes'"; for ids that name nothing, that.
std::string describe(const State& state, BufferId id);
std::string describe(const State& state, TextureId id);
/// Marks what the pass under way leaves behind.
void applyPass(State& state);
void markTransferred(State& state, BufferId id);
void markTransferred(State& state, const TextureView& view);
void markDiscarded(State& state, TextureId id);

}  // namespace rhi::validate
