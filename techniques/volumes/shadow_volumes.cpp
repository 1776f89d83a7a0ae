#include "techniques/volumes/shadow_volumes.h"

#include <algorithm>
#include <cstring>
#include <set>

#include "shaders/common/shared_slots.h"

namespace sb {
namespace {

constexpr uint32_t kArgumentWords = 4 * VOLUME_PARTS;
/// Threads of a row of a dispatch: devices have 65535 groups in one at least.
constexpr uint32_t kRowGroups = 32768, kGroupSize = 64;

uint64_t aligned(uint64_t value, uint64_t to) { return (value + to - 1) / to * to; }

}  // namespace

ShadowVolumes::ShadowVolumes(const Context& context, VolumeBuilder builder,
                             const VolumeChoice& choice, const CullingChoice& culling,
                             const std::function<void(const std::vector<LightVolumes>&)>& visit)
    : m_context(context), m_builder(builder), m_choice(choice), m_culling(context.view, culling) {
  m_edges = EdgeBuffers(context.device, context.view.gpu(),
                        {.edges = STORAGE_TECHNIQUE,
                         .corners = STORAGE_TECHNIQUE + 1,
                         .positions = STORAGE_TECHNIQUE + 2},
                        casterMeshes(), choice.addsUp ? Doubles::Once : Doubles::Each);
  context.view.alongPath(context.device, [&] {
    // From anywhere a camera may see all that is lit.
    update(context.view.isFree() ? m_culling.all() : m_culling.casters());
    visit(m_lights);
  });
  createBuffers();
  if (m_builder == VolumeBuilder::Compute)
    m_append = context.pipelines.get(
        rhi::ComputePipelineDesc{.label = "silhouettes",
                                 .compute = &context.shaders.get("common/volume_silhouette.comp"),
                                 .constants = {}});
  if (context.view.steps() > 1) return;  // each frame writes its own
  bind();
  write([&](rhi::BufferId buffer, std::span<const std::byte> bytes) {
    context.device.upload(buffer, 0, bytes);
  });
}

std::vector<uint32_t> ShadowVolumes::casterMeshes() const {
  std::set<uint32_t> meshes;
  for (const LightCasters& light : m_culling.all())
    for (const uint32_t instance : light.instances)
      meshes.insert(m_context.view.scene().instances[instance].mesh);
  return {meshes.begin(), meshes.end()};
}

void ShadowVolumes::update(const std::vector<LightCasters>& casters) {
  m_lights = lightVolumes(m_context.view, m_edges, m_choice, casters);
  m_items.clear();
  m_firstItem.clear();
  m_loops.clear();
  m_itemCount = 0;
  for (LightVolumes& light : m_lights)
    for (CasterVolume& volume : light.casters) findItems(volume, light.light);
  m_mostItems = std::max(m_mostItems, m_context.view.isFree() ? itemsFromAnywhere() : m_itemCount);
  m_mostVolumes = std::max<uint64_t>(m_mostVolumes, m_firstItem.size());
}

uint64_t ShadowVolumes::itemsFromAnywhere() const {
  const uint64_t start = std::max<uint64_t>(1, m_context.device.info().limits.storageAlignment / 4);
  uint64_t items = 0;
  for (const LightVolumes& light : m_lights)
    for (const CasterVolume& volume : light.casters) {
      // Each edge once for each of its sides, each triangle as either kind of cap.
      const EdgeBuffers::MeshEdges& edges = m_edges.of(volume.mesh);
      items = aligned(items + 2 * uint64_t(edges.edgeCount) + 2 * uint64_t(edges.triangleCount),
                      start);
    }
  return items;
}

void ShadowVolumes::findItems(CasterVolume& volume, uint32_t light) {
  m_firstItem.push_back(m_itemCount);
  volume.data.lists.w = kArgumentWords * volume.number;
  if (!listed()) return;
  const Silhouette* found = nullptr;
  Silhouette sorted;
  if (m_builder == VolumeBuilder::Cpu) {
    const Mesh& mesh = m_context.view.scene().meshes[volume.mesh];
    const EdgeMesh& edges = m_edges.of(volume.mesh).mesh;
    found = &m_silhouettes.of(light, volume, mesh, edges);
    if (m_choice.byLoops) {
      sorted = *found;
      m_loops.push_back(sortByLoops(mesh, edges, sorted));
      found = &sorted;
    }
  }
  uint32_t count = 0;
  for (uint32_t part = 0; part < VOLUME_PARTS; ++part) {
    volume.data.lists[int(part)] = count;
    if (found) {
      volume.items[part] = uint32_t((*found)[part].size());
      m_items.insert(m_items.end(), (*found)[part].begin(), (*found)[part].end());
    }
    count += volume.items[part];
  }
  // Lists start where a binding may.
  const uint64_t start = std::max<uint64_t>(1, m_context.device.info().limits.storageAlignment / 4);
  m_itemCount = aligned(m_itemCount + count, start);
  if (found) m_items.resize(m_itemCount);
}

void ShadowVolumes::createBuffers() {
  using U = rhi::BufferUse;
  const auto make = [&](const char* label, uint64_t size, U use) {
    return m_context.device.createBuffer(
        {.label = label, .size = std::max<uint64_t>(16, size), .use = use | U::CopyTarget});
  };
  const uint64_t stride =
      aligned(sizeof(gpu::VolumeData), m_context.device.info().limits.uniformAlignment);
  m_volumeBlocks = make("shadow volumes", m_mostVolumes * stride, U::Uniform);
  // The last volume may have no items and yet needs a binding.
  if (listed()) m_itemLists = make("shadow volume lists", m_mostItems * 4 + 4, U::Storage);
  if (m_builder != VolumeBuilder::Compute) return;
  const uint64_t bytes = m_mostVolumes * kArgumentWords * sizeof(uint32_t);
  m_arguments = make("shadow volume arguments", bytes, U::Storage | U::Indirect);
  m_noArguments = make("no shadow volume arguments", bytes, U::CopySource);
  std::vector<uint32_t> none;  // vertices, instances, first of each
  for (uint64_t i = 0; i < m_mostVolumes * VOLUME_PARTS; ++i) none.insert(none.end(), {0, 1, 0, 0});
  if (!none.empty()) m_context.device.upload(m_noArguments, 0, std::as_bytes(std::span(none)));
}

void ShadowVolumes::bind() {
  const rhi::Limits& limits = m_context.device.info().limits;
  const uint64_t stride = aligned(sizeof(gpu::VolumeData), limits.uniformAlignment);
  m_bindings.clear();
  for (const LightVolumes& light : m_lights)
    for (const CasterVolume& volume : light.casters) {
      const EdgeBuffers::MeshEdges& edges = m_edges.of(volume.mesh);
      std::vector<rhi::Binding>& bindings = m_bindings.emplace_back(m_context.view.bindings());
      bindings.push_back(rhi::uniformAt(UNIFORM_TECHNIQUE, m_volumeBlocks, volume.number * stride,
                                        sizeof(gpu::VolumeData)));
      for (const StorageWindow* window : {&edges.edges, &edges.corners, &edges.positions})
        bindings.push_back(window->binding);
      if (listed()) {
        uint64_t words = 0;
        for (const uint32_t items : volume.items) words += items;
        bindings.push_back(storageWindow(limits, STORAGE_TECHNIQUE + 3, m_itemLists,
                                         m_firstItem[volume.number] * 4,
                                         std::max<uint64_t>(1, words) * 4)
                               .binding);
      }
      if (m_arguments) bindings.push_back(rhi::storageAt(STORAGE_TECHNIQUE + 4, m_arguments));
    }
}

void ShadowVolumes::write(const Write& write) const {
  const uint64_t stride =
      aligned(sizeof(gpu::VolumeData), m_context.device.info().limits.uniformAlignment);
  std::vector<std::byte> blocks(m_firstItem.size() * stride);
  for (const LightVolumes& light : m_lights)
    for (const CasterVolume& volume : light.casters)
      std::memcpy(blocks.data() + volume.number * stride, &volume.data, sizeof volume.data);
  if (!blocks.empty()) write(m_volumeBlocks, blocks);
  if (!m_items.empty()) write(m_itemLists, std::as_bytes(std::span(m_items)));
}

std::vector<std::pair<std::string, uint64_t>> ShadowVolumes::counts() const {
  auto counts = namedCounts(m_culling.counts());
  if (m_builder != VolumeBuilder::Cpu) return counts;  // nobody else knows
  uint64_t edges = 0;
  for (const LightVolumes& light : m_lights)
    for (const CasterVolume& volume : light.casters) edges += volume.items[VOLUME_SIDES];
  counts.emplace_back("silhouette edges", edges);
  return counts;
}

void ShadowVolumes::moved(Frame& frame) {
  std::vector<LightCasters> casters;
  frame.between("shadow management", PassGroup::Shadow,
                [&](rhi::CommandList&) { casters = m_culling.casters(); });
  update(casters);
  bind();
  write([&](rhi::BufferId buffer, std::span<const std::byte> bytes) {
    frame.commands().write(buffer, 0, bytes);
  });
}

void ShadowVolumes::record(Frame& frame) {
  if (m_builder != VolumeBuilder::Compute || m_lights.empty()) return;
  frame.commands().copy(m_noArguments, 0, m_arguments, 0,
                        m_firstItem.size() * kArgumentWords * sizeof(uint32_t));
  const rhi::ResourceUse writes[] = {rhi::use(m_itemLists.id(), rhi::Access::StorageWrite),
                                     rhi::use(m_arguments.id(), rhi::Access::StorageWrite)};
  frame.pass({.label = "silhouettes", .compute = true, .writes = writes}, PassGroup::Shadow,
             [&](rhi::CommandList& commands) {
               for (const LightVolumes& light : m_lights)
                 for (const CasterVolume& volume : light.casters) {
                   const uint32_t groups =
                       (std::max(volume.data.counts.x, volume.data.counts.y) + kGroupSize - 1) /
                       kGroupSize;
                   commands.dispatch({.pipeline = m_append, .bindings = m_bindings[volume.number]},
                                     std::min(groups, kRowGroups),
                                     (groups + kRowGroups - 1) / kRowGroups);
                 }
             });
}

rhi::GraphicsPipelineDesc ShadowVolumes::pipeline(uint32_t part, uint32_t caps) const {
  const auto shader = [&](const char* name) { return &m_context.shaders.get(name); };
  rhi::GraphicsPipelineDesc desc{.constants = {{16, part}, {17, m_choice.finite}, {20, caps}}};
  if (hasGeometryShader(part)) {
    desc.vertex = shader("common/volume_edges.vert");
    desc.geometry = shader("common/volume_edges.geom");
    desc.topology = rhi::Topology::PointList;
    return desc;
  }
  desc.vertex = shader(listed() ? "common/volume_listed.vert" : "common/volume_everywhere.vert");
  return desc;
}

std::vector<rhi::ResourceUse> ShadowVolumes::reads() const {
  if (m_builder != VolumeBuilder::Compute) return {};
  return {rhi::use(m_itemLists.id(), rhi::Access::StorageRead),
          rhi::use(m_arguments.id(), rhi::Access::Indirect)};
}

void ShadowVolumes::draw(rhi::CommandList& commands, rhi::PipelineId pipeline,
                         const LightVolumes& light, const CasterVolume& volume, uint32_t part,
                         const SilhouetteLoop* loop) const {
  const rhi::DrawState state{.pipeline = pipeline,
                             .bindings = m_bindings[volume.number],
                             .scissor = light.scissor};
  if (m_builder == VolumeBuilder::Compute) {
    const uint64_t at = (volume.data.lists.w + 4 * uint64_t(part)) * 4;
    commands.drawIndirect(state, {.buffer = m_arguments, .offset = at});
    return;
  }
  rhi::DrawArgs draw{.vertexCount = hasGeometryShader(part) ? volume.data.counts.x
                                                            : volume.vertices(part)};
  if (loop) {
    const uint32_t each = volume.verticesOfItem(part);
    draw = {.vertexCount = (*loop)[part].count * each, .firstVertex = (*loop)[part].first * each};
  }
  if (draw.vertexCount > 0) commands.draw(state, draw);
}

}  // namespace sb
