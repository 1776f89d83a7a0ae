// A null device under the validator, with the objects most rules need, and hand-made shaders that
// claim to use this or that slot.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "backends/null/null_backend.h"
#include "backends/rhi/validate/validator.h"

namespace sb::test {

class ValidatorTest : public testing::Test {
 protected:
  ValidatorTest();

  /// Rule names reported since the last call, in order.
  std::vector<std::string> rules();
  /// That exactly this rule was reported, with a text that names `word`.
  void expectOnly(const std::string& rule, const std::string& word);
  void expectClean();

  rhi::Pipeline graphics(std::vector<rhi::ShaderResource> resources,
                         const std::function<void(rhi::GraphicsPipelineDesc&)>& change = {});
  rhi::Pipeline compute(std::vector<rhi::ShaderResource> resources);
  rhi::Buffer buffer(const std::string& label, rhi::BufferUse use, uint64_t size = 1024);
  rhi::Texture texture(const std::string& label, rhi::Format format, rhi::TextureUse use,
                       uint32_t mips = 1);
  /// A frame with one pass; `body` records inside it.
  void pass(
      const rhi::PassDesc& desc,
      const std::function<void(rhi::CommandList&)>& body = [](rhi::CommandList&) {});
  /// A frame with a pass into `m_color` that draws a triangle.
  void drawPass(const rhi::DrawState& state, std::span<const rhi::ResourceUse> reads = {},
                std::span<const rhi::ResourceUse> writes = {});
  /// A frame with a compute pass that writes `id`.
  void writeByPass(rhi::BufferId id, const std::string& label = "writer");
  void writeByPass(rhi::TextureId id, const std::string& label = "writer");

  std::unique_ptr<rhi::Device> m_device;
  std::unique_ptr<rhi::Validator> m_validator;
  rhi::Texture m_color, m_depth;
  rhi::Sampler m_sampler;
};

const rhi::ShaderResource kUniform0 = {0, rhi::ShaderResourceKind::UniformBuffer, true, "Draw"};
const rhi::ShaderResource kReadStorage0 = {8, rhi::ShaderResourceKind::StorageBuffer, true,
                                           "Nodes"};
const rhi::ShaderResource kWriteStorage0 = {8, rhi::ShaderResourceKind::StorageBuffer, false,
                                            "Nodes"};
const rhi::ShaderResource kTexture0 = {24, rhi::ShaderResourceKind::Texture, true, "map"};
const rhi::ShaderResource kWriteImage0 = {56, rhi::ShaderResourceKind::Image, false, "counts"};

}  // namespace sb::test
