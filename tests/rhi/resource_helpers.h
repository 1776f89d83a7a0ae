// Short forms for tests of resources: typed uploads and read-backs, one-shot frames, full-screen
// draws and samples taken by a compute shader.
#pragma once

#include <array>
#include <cstring>
#include <vector>

#include "backends/rhi/device.h"
#include "tests/gpu_test.h"

namespace sb::test {

using Vec4 = std::array<float, 4>;

constexpr rhi::BufferUse kAnyBuffer =
    rhi::BufferUse::Vertex | rhi::BufferUse::Index | rhi::BufferUse::Uniform |
    rhi::BufferUse::Storage | rhi::BufferUse::Indirect | rhi::BufferUse::CopySource |
    rhi::BufferUse::CopyTarget;
constexpr rhi::TextureUse kCopies = rhi::TextureUse::CopySource | rhi::TextureUse::CopyTarget;

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
  return std::as_bytes(std::span<const T>(values));
}
template <class T>
std::vector<T> fromBytes(const std::vector<std::byte>& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

template <class T>
rhi::Buffer bufferOf(rhi::Device& device, const std::vector<T>& values) {
  rhi::Buffer buffer = device.createBuffer(
      {.label = "test buffer", .size = values.size() * sizeof(T), .use = kAnyBuffer});
  device.upload(buffer, 0, bytesOf(values));
  return buffer;
}
template <class T>
std::vector<T> readAll(rhi::Device& device, rhi::BufferId buffer) {
  return fromBytes<T>(device.read(buffer, 0, device.bufferDesc(buffer).size));
}
template <class T>
std::vector<T> readTexels(rhi::Device& device, rhi::TextureId texture,
                          const rhi::TextureRegion& region = {},
                          rhi::Aspect aspect = rhi::Aspect::Color) {
  return fromBytes<T>(device.read(texture, region, aspect));
}

/// A 2-D texture with one mip.
inline rhi::Texture texture2D(rhi::Device& device, rhi::Format format, uint32_t width,
                              uint32_t height, rhi::TextureUse use) {
  return device.createTexture({.label = "test texture",
                               .format = format,
                               .width = width,
                               .height = height,
                               .use = use | kCopies});
}

inline rhi::Pipeline computePipeline(rhi::Device& device, const std::string& name,
                                     std::vector<rhi::SpecConstant> constants = {}) {
  return device.createPipeline(
      rhi::ComputePipelineDesc{.label = name,
                               .compute = &testShaders().get("resources/" + name + ".comp"),
                               .constants = std::move(constants)});
}

/// A pipeline description of two shaders and the formats of its targets.
inline rhi::GraphicsPipelineDesc graphics(const std::string& vertex, const std::string& fragment,
                                          const std::vector<rhi::Format>& targets = {}) {
  rhi::GraphicsPipelineDesc desc{.label = vertex + " " + fragment,
                                 .vertex = &testShaders().get("resources/" + vertex + ".vert")};
  if (!fragment.empty()) desc.fragment = &testShaders().get("resources/" + fragment + ".frag");
  for (rhi::Format format : targets) desc.targets.push_back({.format = format});
  return desc;
}

/// Records one frame and waits for it.
template <class Record>
void frame(rhi::Device& device, Record&& record) {
  record(device.beginFrame());
  device.wait(device.endFrame());
}

inline void computePass(rhi::CommandList& list, rhi::PipelineId pipeline,
                        const std::vector<rhi::Binding>& bindings,
                        const std::vector<rhi::ResourceUse>& reads,
                        const std::vector<rhi::ResourceUse>& writes,
                        std::array<uint32_t, 3> groups) {
  auto pass =
      list.beginPass({.label = "compute", .compute = true, .reads = reads, .writes = writes});
  list.dispatch({.pipeline = pipeline, .bindings = bindings}, groups[0], groups[1], groups[2]);
}

/// What `shader` (of the sample_* family) answers at each coordinate.
std::vector<Vec4> sampleAt(rhi::Device& device, const std::string& shader,
                           const rhi::TextureView& view, rhi::SamplerDesc sampler,
                           const std::vector<Vec4>& at);

inline void expectNear(const Vec4& actual, const Vec4& expected, float tolerance,
                       const std::string& what) {
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << what << " [" << i << "]";
}

}  // namespace sb::test
