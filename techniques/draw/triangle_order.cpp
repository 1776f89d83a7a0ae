#include "techniques/draw/triangle_order.h"

#include <algorithm>
#include <tuple>

#include "shaders/common/shared_slots.h"

namespace sb {
TriangleOrder::TriangleOrder(const Context& context, Instances instances, Rank rank,
                             std::vector<rhi::Binding> extra)
    : m_view(&context.view),
      m_from(std::move(instances)),
      m_rank(std::move(rank)),
      m_centroids(context.view.scene().meshes.size()) {
  // Another step may sort more triangles, or into more runs.
  size_t triangles = 1, runs = 1;
  context.view.alongPath(context.device, [&] {
    sortEntries();
    order();
    triangles = std::max(triangles, m_numbers.size());
    runs = std::max(runs, m_runs.size());
  });
  // From somewhere, no two triangles of one instance may follow one another.
  if (m_view->isFree()) runs = triangles;
  auto make = [&](const char* label, std::span<const std::byte> bytes, uint64_t size,
                  rhi::BufferUse use) {
    rhi::Buffer buffer = context.device.createBuffer({.label = label,
                                                      .size = std::max<uint64_t>(16, size),
                                                      .use = use | rhi::BufferUse::CopyTarget});
    if (m_view->steps() == 1) context.device.upload(buffer, 0, bytes);
    return buffer;
  };
  m_indices = make("sorted indices", std::as_bytes(std::span(m_sortedIndices)), 12 * triangles,
                   rhi::BufferUse::Index);
  m_order = make("sorted triangle order", std::as_bytes(std::span(m_numbers)), 4 * triangles,
                 rhi::BufferUse::Storage);
  m_instances = make("sorted instances", std::as_bytes(std::span(m_records)),
                     runs * sizeof(gpu::InstanceData), rhi::BufferUse::Vertex);
  extra.push_back(rhi::storageAt(STORAGE_TRIANGLE_ORDER, m_order));
  m_drawList = DrawList(*m_view, std::move(extra), true);
}

void TriangleOrder::sort(rhi::CommandList& commands) {
  sortEntries();
  order();
  if (m_numbers.empty()) return;
  commands.write(m_indices, 0, std::as_bytes(std::span(m_sortedIndices)));
  commands.write(m_order, 0, std::as_bytes(std::span(m_numbers)));
  commands.write(m_instances, 0, std::as_bytes(std::span(m_records)));
}

void TriangleOrder::sortEntries() {
  const Scene& scene = m_view->scene();
  m_entries.clear();
  for (const uint32_t i : m_from()) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[instance.mesh];
    auto& centroids = m_centroids[instance.mesh];
    for (uint32_t t = uint32_t(centroids.size()); t < mesh.triangleCount(); ++t) {
      glm::dvec3& centroid = centroids.emplace_back(0);
      for (uint32_t c = 0; c < 3; ++c)
        centroid += glm::dvec3(mesh.positions[mesh.indices[3 * t + c]]) / 3.0;
    }
    const glm::dmat4& toWorld = m_view->placed().toWorld(i);
    const glm::dmat3 linear(toWorld);
    const glm::dvec3 translation = glm::dvec3(toWorld[3]) - m_view->camera().eye;
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
      m_entries.push_back({m_rank(linear * centroids[t] + translation), mesh.key, instance.key,
                           mesh.triangleKeys[t], i, t});
  }
  std::ranges::sort(m_entries, [](const Entry& a, const Entry& b) {
    return std::tie(a.rank, b.meshKey, b.instanceKey, b.triangleKey) <
           std::tie(b.rank, a.meshKey, a.instanceKey, a.triangleKey);
  });
}

void TriangleOrder::order() {
  const Scene& scene = m_view->scene();
  m_sortedIndices.clear();
  m_numbers.clear();
  m_runs.clear();
  for (const Entry& e : m_entries) {
    const Mesh& mesh = scene.meshes[scene.instances[e.instance].mesh];
    m_sortedIndices.insert(m_sortedIndices.end(), mesh.indices.begin() + 3 * e.triangle,
                           mesh.indices.begin() + 3 * e.triangle + 3);
    if (m_runs.empty() || m_runs.back().instance != e.instance)
      m_runs.push_back({.instance = e.instance, .first = uint32_t(m_numbers.size())});
    ++m_runs.back().count;
    m_numbers.push_back(e.triangle);
  }
  m_records.clear();
  for (const Run& run : m_runs)
    m_records.emplace_back(m_view->instance(run.instance)).order.x = run.first;
}

void TriangleOrder::draw(rhi::CommandList& commands, rhi::PipelineId pipeline) {
  const Scene& scene = m_view->scene();
  auto meshOf = [&](size_t run) { return scene.instances[m_runs[run].instance].mesh; };
  for (size_t first = 0; first < m_runs.size();) {
    const uint32_t material = scene.meshes[meshOf(first)].material;
    m_draws.clear();
    size_t i = first;
    for (; i < m_runs.size() && scene.meshes[meshOf(i)].material == material; ++i)
      m_draws.push_back({.indexCount = 3 * m_runs[i].count,
                         .firstIndex = 3 * m_runs[i].first,
                         .vertexOffset = m_view->gpu().mesh(meshOf(i)).vertexOffset,
                         .firstInstance = uint32_t(i)});
    m_drawList.drawOrdered(commands, pipeline, material, m_instances, m_indices, m_draws);
    first = i;
  }
}

}  // namespace sb
