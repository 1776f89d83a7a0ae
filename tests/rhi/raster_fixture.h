// Small pictures for the conformance tests: coloured vertices in clip space, a pipeline with
// defaults to change, one-pass frames, and read-back as typed texels.
#pragma once

#include <cstring>
#include <functional>

#include "tests/gpu_test.h"

namespace sb::test {

constexpr uint32_t kSide = 8;  ///< width and height of the targets

struct Vertex {
  std::array<float, 4> position;
  std::array<float, 4> color = {1, 1, 1, 1};
};
using Vertices = std::vector<Vertex>;
using Color = std::array<float, 4>;

/// Two counter-clockwise triangles (y up) over the texels [x0,x1) x [y0,y1) of a kSide target.
Vertices quad(float x0, float y0, float x1, float y1, float z = 0, Color color = {1, 1, 1, 1});
/// Over the whole target.
Vertices fullQuad(float z = 0, Color color = {1, 1, 1, 1});
/// The same triangles seen from behind.
Vertices reversed(Vertices vertices);

rhi::Texture makeTarget(rhi::Device& device, rhi::Format format, uint32_t samples = 1,
                        uint32_t layers = 1, uint32_t mips = 1);

/// "raster/color" shaders, one RGBA32F target, no depth; `change` edits that.
rhi::Pipeline makePipeline(rhi::Device& device,
                           const std::function<void(rhi::GraphicsPipelineDesc&)>& change = {});

struct DrawCall {
  rhi::PipelineId pipeline;
  Vertices vertices;
  rhi::DrawState state = {};  ///< everything but pipeline and vertex buffers
  uint32_t instances = 1;
};
/// One frame of one pass.
void render(rhi::Device& device, const rhi::PassDesc& pass, const std::vector<DrawCall>& draws);

template <class T>
std::vector<T> texels(rhi::Device& device, rhi::TextureId texture,
                      const rhi::TextureRegion& region = {},
                      rhi::Aspect aspect = rhi::Aspect::Color) {
  const std::vector<std::byte> bytes = device.read(texture, region, aspect);
  std::vector<T> out(bytes.size() / sizeof(T));
  std::memcpy(out.data(), bytes.data(), out.size() * sizeof(T));
  return out;
}

inline size_t at(uint32_t x, uint32_t y) { return size_t(y) * kSide + x; }

}  // namespace sb::test
