// Every rule about transfers and queries.
#include "tests/rhi/validator_fixture.h"

using namespace sb::test;
using rhi::BufferUse;
using rhi::TextureUse;

// Checked on the validator alone: the null device asserts on what lies outside.
class ResourceRules : public ValidatorTest {};

TEST_F(ResourceRules, TransferRange) {
  const rhi::Buffer nodes = buffer("nodes", BufferUse::Storage, 64);
  m_validator->write(nodes, 32, 64);
  expectOnly("transfer-range", "nodes");
  m_validator->fill(nodes, 128, 4);
  expectOnly("transfer-range", "fill");
  m_validator->upload(nodes, 0, 64);
  m_validator->read(nodes, 60, 4);
  expectClean();
}

TEST_F(ResourceRules, TransferFlag) {
  const rhi::Buffer from = buffer("from", BufferUse::CopySource);
  const rhi::Buffer to = buffer("to", BufferUse::Storage);
  rhi::CommandList& list = m_device->beginFrame();
  list.copy(from, 0, to, 0, 16);
  m_device->endFrame();
  expectOnly("transfer-flag", "CopyTarget");
}

TEST_F(ResourceRules, RegionBounds) {
  m_validator->read(m_color, {.mip = 1});
  expectOnly("region-bounds", "colour");
  m_validator->read(m_color, {.x = 4, .width = 5});
  expectOnly("region-bounds", "colour");
  m_validator->read(m_color, {.x = 4, .width = 4});
  expectClean();
}

TEST_F(ResourceRules, CopyMatch) {
  const rhi::Texture other = texture("other", rhi::Format::R32Float, TextureUse::CopyTarget);
  const rhi::TextureView source = {m_color.id()}, target = {other.id()};
  m_validator->copy(source, target);
  expectOnly("copy-match", "other");
}

TEST_F(ResourceRules, QueryIndexAndKind) {
  const rhi::QueryPool times = m_device->createQueryPool({.label = "times", .count = 2});
  const rhi::QueryPool samples = m_device->createQueryPool(
      {.label = "samples", .kind = rhi::QueryKind::Occlusion, .count = 2});
  m_validator->timestamp(times, 2);
  expectOnly("query-index", "times");
  m_validator->timestamp(samples, 0);
  expectOnly("query-kind", "samples");
}

TEST_F(ResourceRules, QueryBalance) {
  const rhi::QueryPool samples = m_device->createQueryPool(
      {.label = "samples", .kind = rhi::QueryKind::Occlusion, .count = 2});
  const rhi::PassDesc desc = {.label = "p", .compute = true};
  pass(desc, [&](rhi::CommandList& list) { list.beginQuery(samples, 0); });
  expectOnly("query-balance", "still open");
  pass(desc, [&](rhi::CommandList& list) { list.endQuery(samples, 0); });
  expectOnly("query-balance", "without a begin");
  pass(desc, [&](rhi::CommandList& list) {
    list.beginQuery(samples, 0);
    list.endQuery(samples, 0);
  });
  expectClean();
}

TEST_F(ResourceRules, QueryReuse) {
  const rhi::QueryPool times = m_device->createQueryPool({.label = "times", .count = 2});
  for (int frame = 0; frame < 2; ++frame) {
    m_device->beginFrame().timestamp(times, 0);
    m_device->endFrame();
  }
  expectClean();
  rhi::CommandList& list = m_device->beginFrame();
  list.timestamp(times, 1);
  list.timestamp(times, 1);
  m_device->endFrame();
  expectOnly("query-reuse", "times");
}

TEST_F(ResourceRules, ARepeatedFindingIsReportedOnceAFrame) {
  const rhi::Pipeline pipeline = graphics({kTexture0});
  const rhi::ColorAttachment color = {.view = {m_color.id()}};
  pass({.label = "p", .colors = {&color, 1}}, [&](rhi::CommandList& list) {
    for (int i = 0; i < 3; ++i) list.draw({.pipeline = pipeline}, {.vertexCount = 3});
  });
  EXPECT_EQ(rules().size(), 1u);
}
