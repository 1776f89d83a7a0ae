// Textures of different parts of a frame share memory, and nothing that is in it.
#include "techniques/draw/frame/transients.h"

#include "backends/rhi/validate/validator.h"
#include "techniques/render/registry.h"
#include "tests/techniques/recorded.h"

namespace sb::test {
namespace {

struct Transience : testing::Test {
  rhi::TextureDesc desc(const char* label) const {
    return {.label = label,
            .format = rhi::Format::R32Float,
            .width = 8,
            .height = 4,
            .use = rhi::TextureUse::ColorTarget | rhi::TextureUse::Sampled};
  }
  std::unique_ptr<rhi::Device> device = null_backend::makeBackend()->open({});
  rhi::Validator validator{*device};
  Transients transients{*device};
};

TEST_F(Transience, PartsThatTakeTurnsShareATexture) {
  const rhi::TextureId counts = transients.texture(desc("counts"), FramePart::Receivers);
  const rhi::TextureId layer = transients.texture(desc("layer"), FramePart::Surfaces);
  EXPECT_EQ(counts, layer);
  EXPECT_EQ(device->ledger().bytesByLabel(),
            (std::map<std::string, uint64_t>{{"counts", 8 * 4 * 4}}));
}

TEST_F(Transience, WithinAPartEachHasItsOwn) {
  const rhi::TextureId first = transients.texture(desc("first"), FramePart::Surfaces);
  const rhi::TextureId second = transients.texture(desc("second"), FramePart::Surfaces);
  EXPECT_NE(first, second);
  EXPECT_EQ(transients.texture(desc("a"), FramePart::Receivers), first);
  EXPECT_EQ(transients.texture(desc("b"), FramePart::Receivers), second);
  EXPECT_EQ(device->ledger().totalBytes(), 2u * 8 * 4 * 4);
}

TEST_F(Transience, OtherDescriptionsDoNotShare) {
  const rhi::TextureId counts = transients.texture(desc("counts"), FramePart::Receivers);
  const std::function<void(rhi::TextureDesc&)> changes[] = {
      [](auto& d) { d.kind = rhi::TextureKind::Tex2DArray; },
      [](auto& d) { d.format = rhi::Format::R16Float; },
      [](auto& d) { d.width = 4; },
      [](auto& d) { d.height = 8; },
      [](auto& d) { d.mips = 2; },
      [](auto& d) { d.samples = 4; },
      [](auto& d) { d.use = d.use | rhi::TextureUse::CopySource; }};
  for (const auto& change : changes) {
    rhi::TextureDesc other = desc("other");
    change(other);
    EXPECT_NE(transients.texture(other, FramePart::Surfaces), counts) << &change - changes;
  }
}

TEST_F(Transience, WhatTheOtherPartLeftIsNotThere) {
  const rhi::TextureId counts = transients.texture(desc("counts"), FramePart::Receivers);
  const rhi::TextureId layer = transients.texture(desc("layer"), FramePart::Surfaces);
  const rhi::ColorAttachment made{.view = {.texture = counts}};
  const rhi::ResourceUse read = rhi::use(layer, rhi::Access::Sampled);
  rhi::FrameScope frame(*device);
  { const auto pass = frame.commands().beginPass({.label = "count", .colors = {&made, 1}}); }
  transients.begin(frame.commands());
  {
    const auto pass =
        frame.commands().beginPass({.label = "compose", .reads = {&read, 1}, .extent = {8, 4}});
  }
  frame.endAndWait();
  const std::vector<rhi::Message> messages = device->takeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].rule, "read-never-written");
}

/// Bytes of a cell on a device that is watched.
uint64_t bytes(const std::string& counter, const std::string& transparency) {
  const auto device = null_backend::makeBackend()->open({});
  rhi::Validator validator(*device);
  uint64_t sum = 0;
  {
    CellDevice shared(*device);
    Cell cell(shared, withPane(opaqueScene()),
              {.technique = "StencilShadowVolume",
               .knobs = {{"counter", counter}},
               .transparency = transparency});
    for (const auto& [label, size] : cell.renderer().bytesByLabel()) sum += size;
  }
  for (const rhi::Message& message : device->takeMessages())
    ADD_FAILURE() << transparency << ": " << message.rule << " " << message.text;
  return sum;
}

TEST(TransientsOfTechniques, CountsOfVolumesTakeNoMemoryBesideTheTotalTransmittance) {
  constexpr uint64_t kCounts = 64 * 64 * 4;
  for (const TransparencyEntry* entry : transparencyTechniques()) {
    const std::string& name = entry->info.name;
    EXPECT_EQ(bytes("float", name) - bytes("stencil8", name),
              name == "StochasticTransparency" ? 0 : kCounts)
        << name;
  }
}

}  // namespace
}  // namespace sb::test
