// Camera transparency by sorted alpha blending (spec 15, A): translucent surfaces back to front,
// premultiplied, ONE / ONE_MINUS_SRC_ALPHA. One pass, no extra memory. Wrong where the order of
// sorting is not the order of fragments: large or intersecting meshes, cycles.
//   sort=mesh      by the view depth of the centre of the bounding box (seed 000)
//   sort=triangle  by the view depth of the centroid of each triangle
#include <algorithm>
#include <cstring>

#include "shaders/common/shared_slots.h"
#include "techniques/common/camera_pass.h"
#include "techniques/common/registry.h"

namespace sb {
namespace {

/// Consecutive triangles of one instance in the sorted order.
struct Run {
  uint32_t instance = 0;
  uint32_t first = 0;  ///< triangle, in sorted order
  uint32_t count = 0;
};

class Sorted final : public TransparencyTechnique {
 public:
  void prepare(const Context& context, CameraPass& camera) override {
    rhi::GraphicsPipelineDesc desc = camera.translucentPipeline("sorted");
    desc.targets.front().blend = {.enabled = true,
                                  .dstColor = rhi::BlendFactor::OneMinusSrcAlpha,
                                  .dstAlpha = rhi::BlendFactor::OneMinusSrcAlpha};
    m_byTriangle = context.knobs.is("sort", "triangle");
    if (m_byTriangle) {
      desc.constants.push_back({3, 1});
      sortTriangles(context, camera);
    } else {
      sortMeshes(context.view);
    }
    m_pipeline = context.pipelines.get(desc);
  }

  void record(Frame& frame, CameraPass& camera) override {
    camera.translucentPass(frame, "translucent", [&](rhi::CommandList& commands) {
      if (m_byTriangle)
        drawRuns(commands);
      else
        camera.drawList().draw(commands, m_pipeline, m_instances);
    });
  }

 private:
  void sortMeshes(const SceneView& view) {
    std::vector<std::pair<double, uint32_t>> order;
    for (uint32_t i : view.effects().visibleTranslucent) {
      const Box box = instanceBounds(view.scene(), i, view.camera().eye);
      order.emplace_back(viewDepth(view, (box.min + box.max) * 0.5), i);
    }
    // Farthest first; the persistent key breaks ties, so that the order of the file plays no part.
    std::ranges::sort(order, [&](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first
                                : view.scene().instances[a.second].key <
                                      view.scene().instances[b.second].key;
    });
    for (const auto& [depth, i] : order) m_instances.push_back(i);
  }

  static double viewDepth(const SceneView& view, const glm::dvec3& relative) {
    return -(view.camera().view * glm::dvec4(relative, 1)).z;
  }

  void sortTriangles(const Context& context, const CameraPass& camera) {
    struct Entry {
      double depth;
      uint32_t instanceKey, triangleKey, instance, triangle;
    };
    const SceneView& view = context.view;
    const Scene& scene = view.scene();
    std::vector<Entry> entries;
    for (uint32_t i : view.effects().visibleTranslucent) {
      const Instance& instance = scene.instances[i];
      const Mesh& mesh = scene.meshes[instance.mesh];
      const glm::dvec3 translation = glm::dvec3(instance.toWorld[3]) - view.camera().eye;
      for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
        glm::dvec3 centroid(0);
        for (uint32_t c = 0; c < 3; ++c)
          centroid += glm::dvec3(mesh.positions[mesh.indices[3 * t + c]]) / 3.0;
        entries.push_back({viewDepth(view, glm::dmat3(instance.toWorld) * centroid + translation),
                           instance.key, mesh.triangleKeys[t], i, t});
      }
    }
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
      return std::tuple(-a.depth, a.instanceKey, a.triangleKey) <
             std::tuple(-b.depth, b.instanceKey, b.triangleKey);
    });
    std::vector<uint32_t> indices, numbers;
    for (const Entry& e : entries) {
      const Mesh& mesh = scene.meshes[scene.instances[e.instance].mesh];
      indices.insert(indices.end(), mesh.indices.begin() + 3 * e.triangle,
                     mesh.indices.begin() + 3 * e.triangle + 3);
      if (m_runs.empty() || m_runs.back().instance != e.instance)
        m_runs.push_back({.instance = e.instance, .first = uint32_t(numbers.size())});
      ++m_runs.back().count;
      numbers.push_back(e.triangle);
    }
    upload(context, camera, indices, numbers);
  }

  void upload(const Context& context, const CameraPass& camera,
              const std::vector<uint32_t>& indices, const std::vector<uint32_t>& numbers) {
    const uint64_t stride = context.view.drawStride();
    std::vector<std::byte> draws(std::max<size_t>(1, m_runs.size()) * stride);
    for (size_t i = 0; i < m_runs.size(); ++i) {
      const gpu::DrawData draw{.ids = {m_runs[i].instance, m_runs[i].first, 0, 0}};
      std::memcpy(draws.data() + i * stride, &draw, sizeof draw);
    }
    auto make = [&](const char* label, std::span<const std::byte> bytes, rhi::BufferUse use) {
      rhi::Buffer buffer =
          context.device.createBuffer({.label = label,
                                       .size = std::max<uint64_t>(16, bytes.size()),
                                       .use = use | rhi::BufferUse::CopyTarget});
      context.device.upload(buffer, 0, bytes);
      return buffer;
    };
    m_indices = make("sorted indices", std::as_bytes(std::span(indices)), rhi::BufferUse::Index);
    m_order = make("sorted triangle order", std::as_bytes(std::span(numbers)),
                   rhi::BufferUse::Storage);
    m_draws = make("sorted draws", draws, rhi::BufferUse::Uniform);
    m_drawStride = stride;
    std::vector<rhi::Binding> extra = camera.inputs().bindings;
    extra.push_back(rhi::storageAt(STORAGE_TRIANGLE_ORDER, m_order));
    m_view = &context.view;
    m_drawList = DrawList(context.view, std::move(extra), true);
  }

  void drawRuns(rhi::CommandList& commands) {
    const Scene& scene = m_view->scene();
    for (size_t i = 0; i < m_runs.size(); ++i) {
      const uint32_t mesh = scene.instances[m_runs[i].instance].mesh;
      m_drawList.drawOrdered(
          commands, m_pipeline, scene.meshes[mesh].material,
          rhi::uniformAt(UNIFORM_DRAW, m_draws, i * m_drawStride, sizeof(gpu::DrawData)), m_indices,
          {.indexCount = 3 * m_runs[i].count,
           .firstIndex = 3 * m_runs[i].first,
           .vertexOffset = m_view->gpu().mesh(mesh).vertexOffset});
    }
  }

  bool m_byTriangle = false;
  rhi::PipelineId m_pipeline;
  std::vector<uint32_t> m_instances;
  std::vector<Run> m_runs;
  rhi::Buffer m_indices, m_order, m_draws;
  uint64_t m_drawStride = 0;
  const SceneView* m_view = nullptr;
  DrawList m_drawList;
};

REGISTER_TECHNIQUE(
    TransparencyTechnique, Sorted,
    (TechniqueInfo{.name = "Sorted",
                   .folder = "sorted",
                   .title = "Sorted alpha blending",
                   .paper = "Porter, Duff 1984; seed 000",
                   .represents = {Effect::CameraTransparency, Effect::CameraLayers},
                   .knobs = {{.name = "sort",
                              .help = "what is sorted back to front: whole meshes or triangles",
                              .fallback = "mesh",
                              .choices = {"mesh", "triangle"}}},
                   .error = "wrong order for large or intersecting surfaces"}));

}  // namespace
}  // namespace sb
