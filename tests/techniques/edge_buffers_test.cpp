// Edges on the device: what a compute shader finds at them is what the CPU finds, and what it
// appends is drawn without the CPU knowing how much that is.
#include "techniques/volumes/edges/edge_buffers.h"

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/rhi/resource_helpers.h"
#include "tests/techniques/gpu_cell.h"

using namespace sb;
using namespace sb::test;

namespace {

int facesLight(const Mesh& mesh, uint32_t t, glm::dvec4 light) {
  const auto corner = [&](uint32_t c) {
    return glm::dvec3(mesh.positions[mesh.indices[3 * size_t(t) + c]]);
  };
  const glm::dvec3 n = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
  return glm::dot(n, glm::dvec3(light) - light.w * corner(0)) > 0 ? 1 : 0;
}

/// Edges that a mesh's contour has on the device: as appended, and as drawn.
struct Contour {
  std::vector<uint32_t> edges;
  float drawn = 0;
};

Contour contourOf(rhi::Device& device, const EdgeBuffers& buffers, uint32_t mesh, glm::vec4 light) {
  const EdgeBuffers::MeshEdges& edges = buffers.of(mesh);
  struct Parameters {
    glm::vec4 light;
    glm::uvec4 counts;
  };
  const std::vector<Parameters> parameters = {
      {light, {edges.edgeCount, edges.edges.first, edges.corners.first, edges.positions.first}}};
  const rhi::Buffer block = bufferOf(device, parameters);
  const rhi::Buffer appended = bufferOf(device, std::vector<uint32_t>(edges.edgeCount + 4, 0));
  const rhi::Buffer arguments = bufferOf(device, std::vector<uint32_t>{3, 0, 0, 0});
  const rhi::Texture target =
      texture2D(device, rhi::Format::R32Float, 1, 1, rhi::TextureUse::ColorTarget);
  const rhi::Pipeline contour = device.createPipeline(rhi::ComputePipelineDesc{
      .label = "contour", .compute = &testShaders().get("edges/contour.comp"), .constants = {}});
  const rhi::Pipeline draw = device.createPipeline(
      rhi::GraphicsPipelineDesc{.label = "instances",
                                .vertex = &testShaders().get("edges/instances.vert"),
                                .fragment = &testShaders().get("edges/one.frag"),
                                .targets = {{.format = rhi::Format::R32Float,
                                             .blend = {.enabled = true,
                                                       .dstColor = rhi::BlendFactor::One,
                                                       .dstAlpha = rhi::BlendFactor::One}}}});
  frame(device, [&](rhi::CommandList& list) {
    const rhi::ResourceUse writes[] = {rhi::use(appended.id(), rhi::Access::StorageWrite),
                                       rhi::use(arguments.id(), rhi::Access::StorageWrite)};
    {
      auto pass = list.beginPass({.label = "contour", .compute = true, .writes = writes});
      const rhi::Binding bindings[] = {rhi::uniformAt(2, block),    edges.edges.binding,
                                       edges.corners.binding,       edges.positions.binding,
                                       rhi::storageAt(9, appended), rhi::storageAt(10, arguments)};
      list.dispatch({.pipeline = contour, .bindings = bindings}, (edges.edgeCount + 63) / 64);
    }
    const rhi::ColorAttachment color{.view = {.texture = target}};
    const rhi::ResourceUse read = rhi::use(arguments.id(), rhi::Access::Indirect);
    auto pass = list.beginPass({.label = "draw", .colors = {&color, 1}, .reads = {&read, 1}});
    list.drawIndirect({.pipeline = draw}, {.buffer = arguments});
  });
  Contour found;
  found.drawn = readTexels<float>(device, target)[0];
  const auto words = device.read(arguments, 4, 4);
  uint32_t count = 0;
  std::memcpy(&count, words.data(), 4);
  const auto bytes = device.read(appended, 0, uint64_t(count) * 4);
  found.edges.resize(count);
  std::memcpy(found.edges.data(), bytes.data(), bytes.size());
  std::ranges::sort(found.edges);
  return found;
}

}  // namespace

GPU_TEST(EdgeBuffers, ShadersFindTheContoursThatTheCpuFinds) {
  Scene scene = makeScene("teapot");
  addBox(scene, 0, {-1, -1, -1}, {1, 1, 1});
  const GpuScene gpu(device(), scene);
  std::vector<uint32_t> meshes;
  for (uint32_t i = 0; i < scene.meshes.size(); ++i) meshes.push_back(i);
  const EdgeBuffers buffers(device(), gpu, {.edges = 6, .corners = 7, .positions = 8}, meshes);
  for (const uint32_t mesh : meshes)
    for (const glm::vec4 light :
         {glm::vec4(0.3, 9, 0.2, 1), glm::vec4(3, -4, 5, 1), glm::vec4(0.3, 0.9, 0.25, 0)}) {
      const EdgeMesh edges = edgeMesh(scene.meshes[mesh]);
      std::vector<uint32_t> expected;
      for (uint32_t i = 0; i < edges.edges.size(); ++i)
        if (edgeMultiplicity(edges.edges[i], [&](uint32_t t) {
              return facesLight(scene.meshes[mesh], t, light);
            }) != 0)
          expected.push_back(i);
      const Contour found = contourOf(device(), buffers, mesh, light);
      EXPECT_EQ(found.edges, expected) << mesh;
      EXPECT_EQ(found.drawn, float(expected.size())) << mesh;
    }
}
