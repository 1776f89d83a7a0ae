#include "techniques/common/triangle_order.h"

#include <algorithm>
#include <cstring>
#include <tuple>

#include "shaders/common/shared_slots.h"

namespace sb {
namespace {

struct Entry {
  double rank;
  uint32_t instanceKey, triangleKey, instance, triangle;
};

std::vector<Entry> sortedEntries(const SceneView& view, std::span<const uint32_t> instances,
                                 const std::function<double(const glm::dvec3&)>& rank) {
  const Scene& scene = view.scene();
  std::vector<Entry> entries;
  for (const uint32_t i : instances) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[instance.mesh];
    const glm::dvec3 translation = glm::dvec3(instance.toWorld[3]) - view.camera().eye;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      glm::dvec3 centroid(0);
      for (uint32_t c = 0; c < 3; ++c)
        centroid += glm::dvec3(mesh.positions[mesh.indices[3 * t + c]]) / 3.0;
      entries.push_back({rank(glm::dmat3(instance.toWorld) * centroid + translation), instance.key,
                         mesh.triangleKeys[t], i, t});
    }
  }
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    return std::tie(a.rank, a.instanceKey, a.triangleKey) <
           std::tie(b.rank, b.instanceKey, b.triangleKey);
  });
  return entries;
}

}  // namespace

TriangleOrder::TriangleOrder(const Context& context, std::span<const uint32_t> instances,
                             const std::function<double(const glm::dvec3&)>& rank,
                             std::vector<rhi::Binding> extra)
    : m_view(&context.view) {
  const Scene& scene = m_view->scene();
  std::vector<uint32_t> indices, numbers;
  for (const Entry& e : sortedEntries(*m_view, instances, rank)) {
    const Mesh& mesh = scene.meshes[scene.instances[e.instance].mesh];
    indices.insert(indices.end(), mesh.indices.begin() + 3 * e.triangle,
                   mesh.indices.begin() + 3 * e.triangle + 3);
    if (m_runs.empty() || m_runs.back().instance != e.instance)
      m_runs.push_back({.instance = e.instance, .first = uint32_t(numbers.size())});
    ++m_runs.back().count;
    numbers.push_back(e.triangle);
  }
  upload(context, indices, numbers, std::move(extra));
}

void TriangleOrder::upload(const Context& context, const std::vector<uint32_t>& indices,
                           const std::vector<uint32_t>& numbers, std::vector<rhi::Binding> extra) {
  m_drawStride = m_view->drawStride();
  std::vector<std::byte> draws(std::max<size_t>(1, m_runs.size()) * m_drawStride);
  for (size_t i = 0; i < m_runs.size(); ++i) {
    const gpu::DrawData draw{.ids = {m_runs[i].instance, m_runs[i].first, 0, 0}};
    std::memcpy(draws.data() + i * m_drawStride, &draw, sizeof draw);
  }
  auto make = [&](const char* label, std::span<const std::byte> bytes, rhi::BufferUse use) {
    rhi::Buffer buffer = context.device.createBuffer({.label = label,
                                                      .size = std::max<uint64_t>(16, bytes.size()),
                                                      .use = use | rhi::BufferUse::CopyTarget});
    context.device.upload(buffer, 0, bytes);
    return buffer;
  };
  m_indices = make("sorted indices", std::as_bytes(std::span(indices)), rhi::BufferUse::Index);
  m_order =
      make("sorted triangle order", std::as_bytes(std::span(numbers)), rhi::BufferUse::Storage);
  m_draws = make("sorted draws", draws, rhi::BufferUse::Uniform);
  extra.push_back(rhi::storageAt(STORAGE_TRIANGLE_ORDER, m_order));
  m_drawList = DrawList(*m_view, std::move(extra), true);
}

void TriangleOrder::draw(rhi::CommandList& commands, rhi::PipelineId pipeline) {
  const Scene& scene = m_view->scene();
  for (size_t i = 0; i < m_runs.size(); ++i) {
    const uint32_t mesh = scene.instances[m_runs[i].instance].mesh;
    m_drawList.drawOrdered(
        commands, pipeline, scene.meshes[mesh].material,
        rhi::uniformAt(UNIFORM_DRAW, m_draws, i * m_drawStride, sizeof(gpu::DrawData)), m_indices,
        {.indexCount = 3 * m_runs[i].count,
         .firstIndex = 3 * m_runs[i].first,
         .vertexOffset = m_view->gpu().mesh(mesh).vertexOffset});
  }
}

}  // namespace sb
