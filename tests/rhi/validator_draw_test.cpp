// Every rule about draws, dispatches and their bindings.
#include "tests/rhi/validator_fixture.h"

using namespace sb::test;
using rhi::Access;
using rhi::BufferUse;
using rhi::TextureUse;

class DrawRules : public ValidatorTest {
 protected:
  /// A compute pass that dispatches once.
  void dispatchPass(rhi::PipelineId pipeline, std::span<const rhi::Binding> bindings,
                    std::span<const rhi::ResourceUse> reads = {},
                    std::span<const rhi::ResourceUse> writes = {}) {
    pass({.label = "compute", .compute = true, .reads = reads, .writes = writes},
         [&](rhi::CommandList& list) {
           list.dispatch({.pipeline = pipeline, .bindings = bindings}, 1);
         });
  }
};

TEST_F(DrawRules, CleanDrawsAreSilent) {
  const rhi::Buffer uniform = buffer("uniform", BufferUse::Uniform);
  const rhi::Buffer nodes = buffer("nodes", BufferUse::Storage);
  const rhi::Texture map =
      texture("map", rhi::Format::R32Uint, TextureUse::Sampled | TextureUse::Storage);
  writeByPass(nodes);
  writeByPass(map);
  const rhi::Pipeline pipeline = graphics({kUniform0, kReadStorage0, kTexture0});
  const rhi::Binding bindings[] = {
      rhi::uniformAt(0, uniform.id(), 256, 64), rhi::storageAt(0, nodes.id()),
      rhi::textureAt(0, map.id(), m_sampler), rhi::storageAt(7, nodes.id(), 3)};
  const rhi::ResourceUse reads[] = {rhi::use(nodes.id(), Access::StorageRead),
                                    rhi::use(map.id(), Access::Sampled)};
  drawPass({.pipeline = pipeline, .bindings = bindings}, reads);
  expectClean();
}

TEST_F(DrawRules, UploadedResourcesNeedNoDeclaration) {
  const rhi::Buffer nodes = buffer("nodes", BufferUse::Storage);
  writeByPass(nodes);
  m_device->beginFrame().fill(nodes, 0, 1024, 0);
  m_device->endFrame();
  const rhi::Pipeline pipeline = graphics({kReadStorage0});
  const rhi::Binding bindings[] = {rhi::storageAt(0, nodes.id())};
  drawPass({.pipeline = pipeline, .bindings = bindings});
  expectClean();
}

TEST_F(DrawRules, MissingBinding) {
  const rhi::Pipeline pipeline = graphics({kTexture0});
  drawPass({.pipeline = pipeline});
  expectOnly("missing-binding", "map");
}

TEST_F(DrawRules, BindingKind) {
  const rhi::Buffer nodes = buffer("nodes", BufferUse::Storage);
  const rhi::Pipeline pipeline = graphics({kTexture0});
  const rhi::Binding wrong[] = {{.slot = 24, .buffer = nodes.id(), .sampler = m_sampler}};
  drawPass({.pipeline = pipeline, .bindings = wrong});
  expectOnly("binding-kind", "map");
  const rhi::Texture map = texture("map", rhi::Format::R32Uint, TextureUse::Sampled);
  const rhi::Binding noSampler[] = {rhi::textureAt(0, map.id(), {})};
  drawPass({.pipeline = pipeline, .bindings = noSampler});
  expectOnly("binding-kind", "sampler");
}

TEST_F(DrawRules, BindingFlag) {
  const rhi::Buffer vertices = buffer("vertices", BufferUse::Vertex);
  const rhi::Texture map = texture("target only", rhi::Format::R32Uint, TextureUse::ColorTarget);
  const rhi::Pipeline reads = graphics({kReadStorage0});
  const rhi::Binding storage[] = {rhi::storageAt(0, vertices.id())};
  drawPass({.pipeline = reads, .bindings = storage});
  expectOnly("binding-flag", "vertices");
  const rhi::Pipeline samples = graphics({kTexture0});
  const rhi::Binding sampled[] = {rhi::textureAt(0, map.id(), m_sampler)};
  drawPass({.pipeline = samples, .bindings = sampled});
  expectOnly("binding-flag", "target only");
}

TEST_F(DrawRules, BindingAlignment) {
  const rhi::Buffer uniform = buffer("uniform", BufferUse::Uniform);
  const rhi::Pipeline pipeline = graphics({kUniform0});
  const rhi::Binding bindings[] = {rhi::uniformAt(0, uniform.id(), 16, 64)};
  drawPass({.pipeline = pipeline, .bindings = bindings});
  expectOnly("binding-alignment", "256");
}

TEST_F(DrawRules, BindingRange) {
  const rhi::Buffer uniform = buffer("uniform", BufferUse::Uniform, 512);
  const rhi::Pipeline pipeline = graphics({kUniform0});
  const rhi::Binding bindings[] = {rhi::uniformAt(0, uniform.id(), 256, 512)};
  drawPass({.pipeline = pipeline, .bindings = bindings});
  expectOnly("binding-range", "uniform");
}

TEST_F(DrawRules, UndeclaredRead) {
  const rhi::Buffer nodes = buffer("nodes", BufferUse::Storage | BufferUse::Index);
  writeByPass(nodes, "build lists");
  const rhi::Pipeline pipeline = graphics({kReadStorage0});
  const rhi::Binding bindings[] = {rhi::storageAt(0, nodes.id())};
  drawPass({.pipeline = pipeline, .bindings = bindings});
  expectOnly("undeclared-read", "build lists");
  const rhi::ResourceUse other[] = {rhi::use(nodes.id(), Access::Index)};
  drawPass({.pipeline = pipeline, .bindings = bindings}, other);
  expectOnly("undeclared-read", "Nodes");
}

TEST_F(DrawRules, UndeclaredReadOfAnAttachment) {
  pass({.label = "shadow map", .depth = rhi::DepthAttachment{.view = {m_depth.id()}}});
  const rhi::Pipeline pipeline = graphics({kTexture0});
  const rhi::Binding bindings[] = {rhi::textureAt(0, m_depth.id(), m_sampler)};
  drawPass({.pipeline = pipeline, .bindings = bindings});
  expectOnly("undeclared-read", "shadow map");
}

TEST_F(DrawRules, UndeclaredReadOfVertices) {
  const rhi::Buffer vertices = buffer("vertices", BufferUse::Storage | BufferUse::Vertex);
  writeByPass(vertices, "skinning");
  const rhi::Pipeline pipeline = graphics({}, [](auto& d) { d.vertexBuffers = {{.stride = 12}}; });
  const rhi::VertexBufferBinding bound = {vertices.id()};
  drawPass({.pipeline = pipeline, .vertexBuffers = {&bound, 1}});
  expectOnly("undeclared-read", "skinning");
}

TEST_F(DrawRules, UndeclaredWrite) {
  const rhi::Buffer nodes = buffer("nodes", BufferUse::Storage);
  const rhi::Texture counts = texture("counts", rhi::Format::R32Uint, TextureUse::Storage);
  const rhi::Binding bindings[] = {rhi::storageAt(0, nodes.id()), rhi::imageAt(0, {counts.id()})};
  const rhi::Pipeline buffers = compute({kWriteStorage0});
  dispatchPass(buffers, bindings);
  expectOnly("undeclared-write", "nodes");
  const rhi::Pipeline images = compute({kWriteImage0});
  dispatchPass(images, bindings);
  expectOnly("undeclared-write", "counts");
  const rhi::ResourceUse writes[] = {rhi::use(nodes.id(), Access::StorageWrite),
                                     rhi::use(counts.id(), Access::StorageWrite)};
  dispatchPass(images, bindings, {}, writes);
  expectClean();
}

TEST_F(DrawRules, BoundAttachment) {
  const rhi::Pipeline pipeline = graphics({kTexture0});
  const rhi::Binding bindings[] = {rhi::textureAt(0, m_color.id(), m_sampler)};
  drawPass({.pipeline = pipeline, .bindings = bindings});
  expectOnly("bound-attachment", "colors[0]");
}

TEST_F(DrawRules, PipelineKind) {
  const rhi::Pipeline kernel = compute({});
  drawPass({.pipeline = kernel});
  expectOnly("pipeline-kind", "graphics pipeline");
}

TEST_F(DrawRules, PipelineAttachments) {
  const rhi::Pipeline format =
      graphics({}, [](auto& d) { d.targets[0].format = rhi::Format::RGBA16Float; });
  drawPass({.pipeline = format});
  expectOnly("pipeline-attachments", "RGBA16F");
  const rhi::Pipeline samples = graphics({}, [](auto& d) { d.samples = 4; });
  drawPass({.pipeline = samples});
  expectOnly("pipeline-attachments", "samples");
  const rhi::Pipeline depth = graphics({}, [](auto& d) { d.depthFormat = rhi::Format::D32Float; });
  drawPass({.pipeline = depth});
  expectOnly("pipeline-attachments", "depth");
}

TEST_F(DrawRules, DepthReadOnly) {
  const rhi::Pipeline writer = graphics({}, [](auto& d) {
    d.targets.clear();
    d.depth = {.test = true, .write = true};
    d.depthFormat = rhi::Format::D32Float;
  });
  pass({.label = "first", .depth = rhi::DepthAttachment{.view = {m_depth.id()}}});
  pass({.label = "p",
        .depth =
            rhi::DepthAttachment{
                .view = {m_depth.id()}, .load = rhi::LoadOp::Load, .readOnly = true}},
       [&](rhi::CommandList& list) { list.draw({.pipeline = writer}, {.vertexCount = 3}); });
  expectOnly("depth-read-only", "read-only");
}

TEST_F(DrawRules, VertexBuffersAndTheirRange) {
  const rhi::Buffer vertices = buffer("vertices", BufferUse::Vertex, 32);
  const rhi::Pipeline pipeline = graphics({}, [](auto& d) {
    d.vertexBuffers = {{.stride = 12}};
    d.attributes = {{.location = 0, .format = rhi::VertexFormat::Float3}};
  });
  drawPass({.pipeline = pipeline});
  expectOnly("vertex-buffers", "vertexBuffers");
  const rhi::VertexBufferBinding bound = {vertices.id()};
  drawPass({.pipeline = pipeline, .vertexBuffers = {&bound, 1}});
  expectOnly("vertex-range", "vertices");
}

TEST_F(DrawRules, IndexBufferAndItsRange) {
  const rhi::Buffer indices = buffer("indices", BufferUse::Index, 8);
  const rhi::Pipeline pipeline = graphics({});
  const rhi::ColorAttachment color = {.view = {m_color.id()}};
  auto drawIndexed = [&](rhi::BufferId id) {
    pass({.label = "p", .colors = {&color, 1}}, [&](rhi::CommandList& list) {
      list.drawIndexed({.pipeline = pipeline, .indexBuffer = id}, {.indexCount = 3});
    });
  };
  drawIndexed({});
  expectOnly("index-buffer", "indexBuffer");
  drawIndexed(indices);
  expectOnly("index-range", "indices");
}

TEST_F(DrawRules, IndirectRange) {
  const rhi::Buffer args = buffer("arguments", BufferUse::Indirect, 16);
  const rhi::Pipeline pipeline = graphics({});
  const rhi::ColorAttachment color = {.view = {m_color.id()}};
  auto drawIndirect = [&](uint32_t count) {
    pass({.label = "p", .colors = {&color, 1}}, [&](rhi::CommandList& list) {
      list.drawIndirect({.pipeline = pipeline}, {.buffer = args, .drawCount = count});
    });
  };
  drawIndirect(1);
  expectClean();
  drawIndirect(2);
  expectOnly("indirect-range", "arguments");
}
