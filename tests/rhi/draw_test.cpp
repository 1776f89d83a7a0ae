// Direct draws: vertex formats, index types and offsets, instancing, per-instance data.
#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

/// cells.vert over a row of 8 cells: what each cell was painted with (0: nothing).
struct Cells {
  explicit Cells(rhi::Device& device)
      : target(texture2D(device, rhi::Format::R32Uint, 8, 1, rhi::TextureUse::ColorTarget)),
        size(bufferOf(device, std::vector<uint32_t>{8, 0, 0, 0})) {
    auto desc = graphics("cells", "cells", {rhi::Format::R32Uint});
    desc.vertexBuffers = {{.stride = 4}};
    desc.attributes = {{.location = 0, .format = rhi::VertexFormat::Uint}};
    pipeline = device.createPipeline(desc);
    // Vertices 6 n .. 6 n + 5 belong to cell n.
    std::vector<uint32_t> cells;
    for (uint32_t i = 0; i < 48; ++i) cells.push_back(i / 6);
    vertices = bufferOf(device, cells);
  }
  template <class Draw>
  std::vector<uint32_t> run(rhi::Device& device, rhi::DrawState state, Draw&& draw) {
    frame(device, [&](rhi::CommandList& list) {
      const rhi::ColorAttachment color{.view = {.texture = target}};
      auto pass = list.beginPass({.label = "cells", .colors = {&color, 1}});
      const rhi::Binding bindings[] = {rhi::uniformAt(0, size)};
      const rhi::VertexBufferBinding buffers[] = {{vertices, vertexOffset}};
      state.pipeline = pipeline;
      state.bindings = bindings;
      state.vertexBuffers = buffers;
      draw(list, state);
    });
    return readTexels<uint32_t>(device, target);
  }
  uint64_t vertexOffset = 0;
  rhi::Texture target;
  rhi::Buffer size, vertices;
  rhi::Pipeline pipeline;
};

using Row = std::vector<uint32_t>;

}  // namespace

GPU_TEST(Draws, FirstVertexAndInstances) {
  Cells cells(device());
  EXPECT_EQ(cells.run(device(), {}, [](auto& list, auto& s) { list.draw(s, {.vertexCount = 12}); }),
            (Row{1, 2, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(
      cells.run(device(), {},
                [](auto& list, auto& s) { list.draw(s, {.vertexCount = 6, .firstVertex = 18}); }),
      (Row{0, 0, 0, 4, 0, 0, 0, 0}));
  EXPECT_EQ(cells.run(device(), {},
                      [](auto& list, auto& s) {
                        list.draw(s, {.vertexCount = 6, .instanceCount = 3, .firstVertex = 6});
                      }),
            (Row{0, 2, 3, 4, 0, 0, 0, 0}));
}

GPU_TEST(Draws, VertexBufferOffset) {
  Cells cells(device());
  cells.vertexOffset = 5 * 6 * 4;
  EXPECT_EQ(cells.run(device(), {}, [](auto& list, auto& s) { list.draw(s, {.vertexCount = 6}); }),
            (Row{0, 0, 0, 0, 0, 6, 0, 0}));
}

GPU_TEST(Draws, IndexTypesAndEveryOffset) {
  Cells cells(device());
  rhi::Buffer words =
      bufferOf(device(), std::vector<uint32_t>{9, 9, 0, 1, 2, 3, 4, 5, 12, 13, 14, 15, 16, 17});
  rhi::Buffer shorts =
      bufferOf(device(), std::vector<uint16_t>{9, 9, 0, 1, 2, 3, 4, 5, 12, 13, 14, 15, 16, 17});
  for (bool wide : {true, false}) {
    rhi::DrawState state{.indexBuffer = wide ? words : shorts,
                         .indexOffset = wide ? 4u : 2u,
                         .indexType = wide ? rhi::IndexType::Uint32 : rhi::IndexType::Uint16};
    EXPECT_EQ(cells.run(device(), state,
                        [](auto& list, auto& s) {
                          list.drawIndexed(s, {.indexCount = 12, .firstIndex = 1});
                        }),
              (Row{1, 0, 3, 0, 0, 0, 0, 0}));
    EXPECT_EQ(
        cells.run(device(), state,
                  [](auto& list, auto& s) {
                    list.drawIndexed(
                        s,
                        {.indexCount = 6, .instanceCount = 2, .firstIndex = 7, .vertexOffset = 24});
                  }),
        (Row{0, 0, 0, 0, 0, 0, 7, 8}));
    EXPECT_EQ(cells.run(device(), state,
                        [](auto& list, auto& s) {
                          list.drawIndexed(s,
                                           {.indexCount = 6, .firstIndex = 7, .vertexOffset = -6});
                        }),
              (Row{0, 2, 0, 0, 0, 0, 0, 0}));
  }
}

GPU_TEST(Draws, ManyWithOneState) {
  // Two meshes, quads of two triangles, over 8 cells of 2 x 1 pixels: the pixels of a cell see
  // different triangles. Attributes of instances count from firstInstance, triangles anew in each
  // instance; of draws over one cell the last remains; neighbours that could be one call and
  // others.
  rhi::Texture target =
      texture2D(device(), rhi::Format::R32Uint, 16, 1, rhi::TextureUse::ColorTarget);
  rhi::Buffer size = bufferOf(device(), std::vector<uint32_t>{8, 0, 0, 0});
  rhi::Buffer vertices = bufferOf(device(), std::vector<uint32_t>{0, 1, 2, 3, 4, 5, 6, 7});
  // Diagonals through the cell's middle put its left pixel into one triangle, its right into
  // another.
  rhi::Buffer indices = bufferOf(device(), std::vector<uint32_t>{0, 1, 2, 3, 2, 1});
  rhi::Buffer cells = bufferOf(device(), std::vector<uint32_t>{7, 6, 5, 4, 3, 2, 1, 0});
  auto desc = graphics("instances", "instances", {rhi::Format::R32Uint});
  desc.vertexBuffers = {{.stride = 4}, {.stride = 4, .perInstance = true}};
  desc.attributes = {{.location = 0, .buffer = 0, .format = rhi::VertexFormat::Uint},
                     {.location = 1, .buffer = 1, .format = rhi::VertexFormat::Uint}};
  rhi::Pipeline pipeline = device().createPipeline(desc);
  rhi::Counters counters;
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ColorAttachment color{.view = {.texture = target}};
    auto pass = list.beginPass({.label = "many", .colors = {&color, 1}});
    const rhi::Binding bindings[] = {rhi::uniformAt(0, size)};
    const rhi::VertexBufferBinding buffers[] = {{vertices}, {cells}};
    const rhi::DrawState state{.pipeline = pipeline,
                               .bindings = bindings,
                               .vertexBuffers = buffers,
                               .indexBuffer = indices};
    const rhi::DrawIndexedArgs draws[] = {
        {.indexCount = 6, .firstInstance = 0},                     // cell 7
        {.indexCount = 6, .firstInstance = 1},                     // cell 6: joined with it
        {.indexCount = 6, .firstInstance = 4},                     // cell 3: not the next
        {.indexCount = 6, .vertexOffset = 4, .firstInstance = 2},  // another mesh
        {.indexCount = 6, .firstInstance = 5},                     // cell 2
        {.indexCount = 6, .vertexOffset = 4, .firstInstance = 5},  // over it
        {.indexCount = 3, .firstInstance = 7},                     // half of cell 0
    };
    list.drawIndexed(state, draws);
    counters = list.counters();
  });
  EXPECT_EQ(readTexels<uint32_t>(device(), target),
            (Row{1, 0, 0, 0, 11, 12, 1, 2, 0, 0, 11, 12, 1, 2, 1, 2}));
  EXPECT_EQ(counters.draws, 7u);
  EXPECT_EQ(counters.triangles, 13u);
}

GPU_TEST(Draws, EveryVertexFormat) {
  struct Vertex {
    float a, b[2], c[3], d[4];
    uint32_t e, f[2], g[4];
    uint8_t h[4];
  };
  static_assert(sizeof(Vertex) == 72);
  std::vector<Vertex> vertices = {{1,
                                   {2, 3},
                                   {4, 5, 6},
                                   {7, 8, 9, 10},
                                   0xFFFFFFFF,
                                   {1, 2},
                                   {1, 2, 4, 0x80000000},
                                   {0, 51, 102, 255}}};
  std::vector<float> instances;  // the middle of pixel i of a row of four
  for (int i = 0; i < 4; ++i) instances.insert(instances.end(), {(float(i) + 0.5f) / 2 - 1, 0});
  rhi::Buffer vertexBuffer = bufferOf(device(), vertices);
  rhi::Buffer instanceBuffer = bufferOf(device(), instances);
  using enum rhi::Format;
  rhi::Texture floats = texture2D(device(), RGBA32Float, 4, 1, rhi::TextureUse::ColorTarget);
  rhi::Texture uints = texture2D(device(), RGBA32Uint, 4, 1, rhi::TextureUse::ColorTarget);
  rhi::Texture colors = texture2D(device(), RGBA8Unorm, 4, 1, rhi::TextureUse::ColorTarget);
  auto desc = graphics("attributes", "attributes", {RGBA32Float, RGBA32Uint, RGBA8Unorm});
  desc.topology = rhi::Topology::PointList;
  desc.vertexBuffers = {{.stride = sizeof(Vertex)}, {.stride = 8, .perInstance = true}};
  using F = rhi::VertexFormat;
  desc.attributes = {{0, 0, F::Float, offsetof(Vertex, a)},
                     {1, 0, F::Float2, offsetof(Vertex, b)},
                     {2, 0, F::Float3, offsetof(Vertex, c)},
                     {3, 0, F::Float4, offsetof(Vertex, d)},
                     {4, 0, F::Uint, offsetof(Vertex, e)},
                     {5, 0, F::Uint2, offsetof(Vertex, f)},
                     {6, 0, F::Uint4, offsetof(Vertex, g)},
                     {7, 0, F::Unorm8x4, offsetof(Vertex, h)},
                     {8, 1, F::Float2, 0}};
  rhi::Pipeline pipeline = device().createPipeline(desc);
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ColorAttachment targets[] = {
        {.view = {.texture = floats}}, {.view = {.texture = uints}}, {.view = {.texture = colors}}};
    auto pass = list.beginPass({.label = "attributes", .colors = targets});
    const rhi::VertexBufferBinding buffers[] = {{vertexBuffer}, {instanceBuffer}};
    list.draw({.pipeline = pipeline, .vertexBuffers = buffers},
              {.vertexCount = 1, .instanceCount = 4});
  });
  for (uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(readTexels<Vec4>(device(), floats)[i], (Vec4{1, 5, 15, 34})) << i;
    EXPECT_EQ((readTexels<std::array<uint32_t, 4>>(device(), uints)[i]),
              (std::array<uint32_t, 4>{0xFFFFFFFF, 3, 0x80000007, 0}))
        << i;
    EXPECT_EQ((readTexels<std::array<uint8_t, 4>>(device(), colors)[i]),
              (std::array<uint8_t, 4>{0, 51, 102, 255}))
        << i;
  }
}

GPU_TEST(Draws, ManyDrawsThatDifferByAUniformOffset) {
  Cells cells(device());
  const uint32_t step = device().info().limits.uniformAlignment;
  std::vector<uint32_t> sizes(step / 4 * 2, 0);
  sizes[0] = 8;         // eight cells: cell 0 is pixel 0
  sizes[step / 4] = 4;  // four cells: cell 1 covers pixels 2 and 3
  rhi::Buffer uniforms = bufferOf(device(), sizes);
  const auto row = cells.run(device(), {}, [&](rhi::CommandList& list, rhi::DrawState state) {
    for (uint32_t i = 0; i < 100; ++i) {
      const rhi::Binding bindings[] = {rhi::uniformAt(0, uniforms, (i % 2) * step, 16)};
      state.bindings = bindings;
      list.draw(state, {.vertexCount = 6, .firstVertex = (i % 2) * 6});
    }
  });
  EXPECT_EQ(row, (Row{1, 0, 2, 2, 0, 0, 0, 0}));
}
