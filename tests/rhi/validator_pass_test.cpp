// Every rule about what a pass declares: provoked once, and silent in a clean frame.
#include "tests/rhi/validator_fixture.h"

using namespace sb::test;
using rhi::Access;
using rhi::BufferUse;
using rhi::TextureUse;

class PassRules : public ValidatorTest {};

TEST_F(PassRules, CleanFramesAreSilent) {
  const rhi::ColorAttachment color = {.view = {m_color.id()}};
  pass({.label = "clear",
        .colors = {&color, 1},
        .depth = rhi::DepthAttachment{.view = {m_depth.id()}}});
  const rhi::ColorAttachment load = {.view = {m_color.id()}, .load = rhi::LoadOp::Load};
  const rhi::ResourceUse reads[] = {rhi::use(m_depth.id(), Access::Sampled)};
  pass({.label = "read-only depth, sampled",
        .colors = {&load, 1},
        .depth =
            rhi::DepthAttachment{
                .view = {m_depth.id()}, .load = rhi::LoadOp::Load, .readOnly = true},
        .reads = reads});
  expectClean();
}

TEST_F(PassRules, UseTarget) {
  const rhi::ResourceUse use = {};
  pass({.label = "p", .compute = true, .reads = {&use, 1}});
  expectOnly("use-target", "reads");
}

TEST_F(PassRules, UseAccess) {
  const rhi::Buffer nodes = buffer("nodes", BufferUse::Storage);
  writeByPass(nodes);
  const rhi::ResourceUse write = rhi::use(nodes.id(), Access::StorageWrite);
  pass({.label = "p", .compute = true, .reads = {&write, 1}});
  expectOnly("use-access", "nodes");
}

TEST_F(PassRules, UseFlag) {
  const rhi::Buffer nodes = buffer("nodes", BufferUse::Vertex);
  writeByPass(nodes);
  expectOnly("use-flag", "nodes");
  const rhi::Texture plain = texture("plain", rhi::Format::R32Uint, TextureUse::Sampled);
  writeByPass(plain);
  expectOnly("use-flag", "plain");
}

TEST_F(PassRules, AttachmentFlag) {
  const rhi::Texture plain = texture("plain", rhi::Format::RGBA8Unorm, TextureUse::Sampled);
  const rhi::ColorAttachment color = {.view = {plain.id()}};
  pass({.label = "p", .colors = {&color, 1}});
  expectOnly("attachment-flag", "colors[0]");
}

TEST_F(PassRules, ViewRange) {
  const rhi::ColorAttachment color = {
      .view = {.texture = m_color.id(), .baseMip = 3, .mipCount = 1}};
  pass({.label = "p", .colors = {&color, 1}});
  expectOnly("view-range", "colors[0]");
}

TEST_F(PassRules, DestroyedResource) {
  rhi::Buffer nodes = buffer("nodes", BufferUse::Storage);
  const rhi::ResourceUse write = rhi::use(nodes.id(), Access::StorageWrite);
  nodes.reset();
  pass({.label = "p", .compute = true, .writes = {&write, 1}});
  expectOnly("destroyed-resource", "writes");
}

TEST_F(PassRules, AttachmentShape) {
  const rhi::Texture mips = texture("mips", rhi::Format::RGBA8Unorm, TextureUse::ColorTarget, 2);
  const rhi::ColorAttachment two = {.view = {mips.id()}};
  pass({.label = "p", .colors = {&two, 1}});
  expectOnly("attachment-shape", "more than one mip");
  const rhi::ColorAttachment both[] = {
      {.view = {m_color.id()}}, {.view = {.texture = mips.id(), .baseMip = 1, .mipCount = 1}}};
  pass({.label = "p", .colors = both});
  expectOnly("attachment-shape", "colors[1]");
}

TEST_F(PassRules, PassExtent) {
  pass({.label = "p"});
  expectOnly("pass-extent", "extent");
  const rhi::ColorAttachment color = {.view = {m_color.id()}};
  pass({.label = "p", .compute = true, .colors = {&color, 1}});
  expectOnly("pass-extent", "compute");
}

TEST_F(PassRules, ReadNeverWritten) {
  const rhi::Buffer nodes = buffer("nodes", BufferUse::Storage);
  const rhi::ResourceUse read = rhi::use(nodes.id(), Access::StorageRead);
  pass({.label = "p", .compute = true, .reads = {&read, 1}});
  expectOnly("read-never-written", "nodes");
  const uint32_t zero = 0;
  m_device->upload(nodes, 0, std::as_bytes(std::span(&zero, 1)));
  pass({.label = "p", .compute = true, .reads = {&read, 1}});
  expectClean();
}

TEST_F(PassRules, LoadNeverWritten) {
  const rhi::ColorAttachment load = {.view = {m_color.id()}, .load = rhi::LoadOp::Load};
  pass({.label = "p", .colors = {&load, 1}});
  expectOnly("load-never-written", "colour");
}

TEST_F(PassRules, WhatWasNotStoredCannotBeLoaded) {
  const rhi::ColorAttachment lost = {.view = {m_color.id()}, .store = rhi::StoreOp::DontCare};
  const rhi::ColorAttachment load = {.view = {m_color.id()}, .load = rhi::LoadOp::Load};
  pass({.label = "p", .colors = {&lost, 1}});
  pass({.label = "p", .colors = {&load, 1}});
  expectOnly("load-never-written", "colour");
}

TEST_F(PassRules, WhatWasDiscardedIsNotThere) {
  const rhi::Texture layer =
      texture("layer", rhi::Format::RGBA8Unorm, TextureUse::ColorTarget | TextureUse::Sampled);
  const rhi::ColorAttachment made = {.view = {layer.id()}};
  const rhi::ResourceUse read = rhi::use(layer.id(), Access::Sampled);
  const auto readLayer = [&] { pass({.label = "p", .compute = true, .reads = {&read, 1}}); };
  pass({.label = "made", .colors = {&made, 1}});
  readLayer();
  expectClean();
  {
    const rhi::FrameScope frame(*m_device);
    frame.commands().discard(layer);
  }
  readLayer();
  expectOnly("read-never-written", "layer");
  pass({.label = "made", .colors = {&made, 1}});
  readLayer();
  expectClean();
}

TEST_F(PassRules, ReadOnlyDepth) {
  pass({.label = "p", .depth = rhi::DepthAttachment{.view = {m_depth.id()}, .readOnly = true}});
  expectOnly("read-only-depth", "load");
}

TEST_F(PassRules, StencilHasRulesOfItsOwn) {
  const rhi::Texture both = texture("both", rhi::Format::D32FloatS8,
                                    TextureUse::DepthTarget | TextureUse::Sampled);
  const rhi::DepthAttachment clear{.view = {both.id()}};
  const rhi::ResourceUse read = rhi::use(both.id(), Access::Sampled);
  pass({.label = "clear", .depth = clear});
  // Depth is read, while stencil is cleared and written.
  pass({.label = "light",
        .depth = rhi::DepthAttachment{
            .view = {both.id()}, .load = rhi::LoadOp::Load, .readOnly = true},
        .reads = {&read, 1}});
  expectClean();
  pass({.label = "p",
        .depth = rhi::DepthAttachment{.view = {both.id()}, .stencilReadOnly = true}});
  expectOnly("read-only-depth", "stencilLoad");
  pass({.label = "lost",
        .depth = rhi::DepthAttachment{.view = {both.id()}, .stencilStore = rhi::StoreOp::DontCare}});
  expectClean();
  pass({.label = "p",
        .depth = rhi::DepthAttachment{.view = {both.id()}, .stencilLoad = rhi::LoadOp::Load}});
  expectOnly("load-never-written", "stencil");
}

TEST_F(PassRules, AttachmentFeedback) {
  const rhi::ColorAttachment color = {.view = {m_color.id()}};
  pass({.label = "p", .colors = {&color, 1}});
  const rhi::ResourceUse read = rhi::use(m_color.id(), Access::Sampled);
  pass({.label = "p", .colors = {&color, 1}, .reads = {&read, 1}});
  expectOnly("attachment-feedback", "colors[0]");
}

TEST_F(PassRules, AnotherMipIsNoFeedback) {
  const rhi::Texture mips =
      texture("mips", rhi::Format::RGBA8Unorm, TextureUse::ColorTarget | TextureUse::Sampled, 2);
  const rhi::ColorAttachment top = {.view = {.texture = mips.id(), .mipCount = 1}};
  const rhi::ColorAttachment next = {.view = {.texture = mips.id(), .baseMip = 1, .mipCount = 1}};
  const rhi::ResourceUse read =
      rhi::use(rhi::TextureView{.texture = mips.id(), .mipCount = 1}, Access::Sampled);
  pass({.label = "p", .colors = {&top, 1}});
  pass({.label = "p", .colors = {&next, 1}, .reads = {&read, 1}});
  expectClean();
}
