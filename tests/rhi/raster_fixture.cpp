#include "tests/rhi/raster_fixture.h"

#include <algorithm>

namespace sb::test {

Vertices quad(float x0, float y0, float x1, float y1, float z, Color color) {
  auto clip = [](float texel) { return texel * 2 / kSide - 1; };
  const float l = clip(x0), r = clip(x1), b = clip(y0), t = clip(y1);
  return {{{l, b, z, 1}, color}, {{r, b, z, 1}, color}, {{r, t, z, 1}, color},
          {{l, b, z, 1}, color}, {{r, t, z, 1}, color}, {{l, t, z, 1}, color}};
}

Vertices fullQuad(float z, Color color) { return quad(0, 0, kSide, kSide, z, color); }

Vertices reversed(Vertices vertices) {
  std::ranges::reverse(vertices);
  return vertices;
}

rhi::Texture makeTarget(rhi::Device& device, rhi::Format format, uint32_t samples, uint32_t layers,
                        uint32_t mips) {
  const bool depth = rhi::formatInfo(format).depth;
  return device.createTexture({
      .label = "raster target",
      .kind = layers > 1 ? rhi::TextureKind::Tex2DArray : rhi::TextureKind::Tex2D,
      .format = format,
      .width = kSide,
      .height = kSide,
      .layers = layers,
      .mips = mips,
      .samples = samples,
      .use = (depth ? rhi::TextureUse::DepthTarget : rhi::TextureUse::ColorTarget) |
             rhi::TextureUse::Sampled | rhi::TextureUse::CopySource,
  });
}

rhi::Pipeline makePipeline(rhi::Device& device,
                           const std::function<void(rhi::GraphicsPipelineDesc&)>& change) {
  rhi::GraphicsPipelineDesc desc = {
      .label = "raster pipeline",
      .vertex = &testShaders().get("raster/color.vert"),
      .fragment = &testShaders().get("raster/color.frag"),
      .vertexBuffers = {{.stride = sizeof(Vertex)}},
      .attributes = {{.location = 0, .format = rhi::VertexFormat::Float4},
                     {.location = 1, .format = rhi::VertexFormat::Float4, .offset = 16}},
      .targets = {{.format = rhi::Format::RGBA32Float}},
  };
  if (change) change(desc);
  return device.createPipeline(desc);
}

void render(rhi::Device& device, const rhi::PassDesc& pass, const std::vector<DrawCall>& draws) {
  std::vector<rhi::Buffer> buffers;
  for (const DrawCall& call : draws) {
    buffers.push_back(device.createBuffer({.label = "raster vertices",
                                           .size = call.vertices.size() * sizeof(Vertex),
                                           .use = rhi::BufferUse::Vertex}));
    device.upload(buffers.back(), 0, std::as_bytes(std::span(call.vertices)));
  }
  rhi::CommandList& list = device.beginFrame();
  {
    auto scope = list.beginPass(pass);
    for (size_t i = 0; i < draws.size(); ++i) {
      const rhi::VertexBufferBinding vertices = {buffers[i]};
      rhi::DrawState state = draws[i].state;
      state.pipeline = draws[i].pipeline;
      state.vertexBuffers = {&vertices, 1};
      list.draw(state, {.vertexCount = uint32_t(draws[i].vertices.size()),
                        .instanceCount = draws[i].instances});
    }
  }
  device.wait(device.endFrame());
}

}  // namespace sb::test
