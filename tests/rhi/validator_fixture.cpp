#include "tests/rhi/validator_fixture.h"

namespace sb::test {

using rhi::TextureUse;

ValidatorTest::ValidatorTest()
    : m_device(null_backend::makeBackend()->open({})),
      m_validator(std::make_unique<rhi::Validator>(*m_device)) {
  m_color = texture("colour", rhi::Format::RGBA8Unorm,
                    TextureUse::ColorTarget | TextureUse::Sampled | TextureUse::CopySource);
  m_depth = texture("depth", rhi::Format::D32Float, TextureUse::DepthTarget | TextureUse::Sampled);
  m_sampler = m_device->createSampler({.label = "sampler"});
}

std::vector<std::string> ValidatorTest::rules() {
  std::vector<std::string> names;
  for (const rhi::Message& message : m_device->takeMessages()) names.push_back(message.rule);
  return names;
}

void ValidatorTest::expectOnly(const std::string& rule, const std::string& word) {
  const std::vector<rhi::Message> messages = m_device->takeMessages();
  ASSERT_FALSE(messages.empty()) << "nothing reported, not even " << rule;
  for (const rhi::Message& message : messages) {
    EXPECT_EQ(message.source, "rhi");
    EXPECT_EQ(message.rule, rule) << message.text;
    EXPECT_NE(message.text.find(word), std::string::npos) << message.text;
  }
}

void ValidatorTest::expectClean() {
  for (const rhi::Message& message : m_device->takeMessages())
    ADD_FAILURE() << message.rule << ": " << message.text;
}

rhi::Pipeline ValidatorTest::graphics(
    std::vector<rhi::ShaderResource> resources,
    const std::function<void(rhi::GraphicsPipelineDesc&)>& change) {
  const rhi::ShaderCode vertex = {.name = "v", .stage = rhi::ShaderStage::Vertex};
  const rhi::ShaderCode fragment = {
      .name = "f", .stage = rhi::ShaderStage::Fragment, .resources = std::move(resources)};
  rhi::GraphicsPipelineDesc desc = {.label = "pipeline",
                                    .vertex = &vertex,
                                    .fragment = &fragment,
                                    .targets = {{.format = rhi::Format::RGBA8Unorm}}};
  if (change) change(desc);
  return m_device->createPipeline(desc);
}

rhi::Pipeline ValidatorTest::compute(std::vector<rhi::ShaderResource> resources) {
  const rhi::ShaderCode code = {
      .name = "c", .stage = rhi::ShaderStage::Compute, .resources = std::move(resources)};
  return m_device->createPipeline(rhi::ComputePipelineDesc{.label = "kernel", .compute = &code});
}

rhi::Buffer ValidatorTest::buffer(const std::string& label, rhi::BufferUse use, uint64_t size) {
  return m_device->createBuffer({.label = label, .size = size, .use = use});
}

rhi::Texture ValidatorTest::texture(const std::string& label, rhi::Format format, TextureUse use,
                                    uint32_t mips) {
  return m_device->createTexture(
      {.label = label, .format = format, .width = 8, .height = 8, .mips = mips, .use = use});
}

void ValidatorTest::pass(const rhi::PassDesc& desc,
                         const std::function<void(rhi::CommandList&)>& body) {
  rhi::CommandList& list = m_device->beginFrame();
  {
    auto scope = list.beginPass(desc);
    body(list);
  }
  m_device->endFrame();
}

void ValidatorTest::drawPass(const rhi::DrawState& state, std::span<const rhi::ResourceUse> reads,
                             std::span<const rhi::ResourceUse> writes) {
  const rhi::ColorAttachment color = {.view = {m_color.id()}};
  pass({.label = "reader", .colors = {&color, 1}, .reads = reads, .writes = writes},
       [&](rhi::CommandList& list) { list.draw(state, {.vertexCount = 3}); });
}

void ValidatorTest::writeByPass(rhi::BufferId id, const std::string& label) {
  const rhi::ResourceUse use = rhi::use(id, rhi::Access::StorageWrite);
  pass({.label = label, .compute = true, .writes = {&use, 1}});
}

void ValidatorTest::writeByPass(rhi::TextureId id, const std::string& label) {
  const rhi::ResourceUse use = rhi::use(id, rhi::Access::StorageWrite);
  pass({.label = label, .compute = true, .writes = {&use, 1}});
}

}  // namespace sb::test
