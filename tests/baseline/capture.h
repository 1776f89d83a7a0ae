// A frame as plain data: what a cell of the program draws, taken from the null backend with its
// buffers' contents. Programs that draw it by hand (by_hand.h) start from there, so that both draw
// the same scene with the same shaders. Scenes without textures.
#pragma once

#include <map>
#include <memory>

#include "backends/rhi/device.h"
#include "techniques/scene/scene.h"

namespace sb::baseline {

struct ById {
  template <class Tag>
  bool operator()(rhi::Id<Tag> a, rhi::Id<Tag> b) const {
    return a.value < b.value;
  }
};
template <class Id, class T>
using IdMap = std::map<Id, T, ById>;

/// One mesh.
struct CapturedDraw {
  rhi::PipelineId pipeline;
  std::vector<rhi::Binding> bindings;
  std::vector<rhi::VertexBufferBinding> vertexBuffers;
  rhi::BufferId indexBuffer;
  rhi::DrawIndexedArgs args;
};

struct CapturedPass {
  std::string label;
  std::vector<rhi::ColorAttachment> colors;
  std::optional<rhi::DepthAttachment> depth;
  std::vector<CapturedDraw> draws;
};

struct CapturedBuffer {
  rhi::BufferDesc desc;
  std::vector<std::byte> bytes;
};

struct Capture {
  IdMap<rhi::BufferId, CapturedBuffer> buffers;
  IdMap<rhi::TextureId, rhi::TextureDesc> textures;
  IdMap<rhi::SamplerId, rhi::SamplerDesc> samplers;
  IdMap<rhi::PipelineId, rhi::GraphicsPipelineDesc> pipelines;
  std::vector<CapturedPass> passes;
  rhi::TextureId picture;  ///< the camera's colour, RGBA16Float
};

/// ShadowMap of a scene with default knobs.
Capture captureShadowMap(const Scene& scene, const rhi::ShaderLibrary& shaders, rhi::Extent2D size);

}  // namespace sb::baseline
