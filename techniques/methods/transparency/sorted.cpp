// Camera transparency by sorted alpha blending (spec 15, A): translucent surfaces back to front,
// premultiplied, ONE / ONE_MINUS_SRC_ALPHA; where the scene has glass, two sources and ONE /
// SRC1_COLOR. One pass, no extra memory. Wrong where the order of sorting is not the order of
// fragments: large or intersecting meshes, cycles.
//   sort=mesh      by the view depth of the centre of the bounding box (Modisett 2023)
//   sort=triangle  by the view depth of the centroid of each triangle
#include "techniques/draw/triangle_order.h"
#include "techniques/draw/views/view_order.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

class Sorted final : public TransparencyTechnique {
 public:
  void prepare(const Context& context, CameraPass& camera) override {
    const bool coloured = context.plan.runs(Effect::ColouredTransparency);
    std::string folder = coloured ? "sorted/coloured" : "sorted";
    if (camera.coplanar()) folder += "/coplanar";
    rhi::GraphicsPipelineDesc desc = camera.translucentPipeline(folder);
    std::vector<rhi::Binding> bindings = camera.inputs().bindings;
    if (camera.coplanar()) {
      desc.depth = {};
      desc.depthFormat = rhi::Format::Undefined;
      bindings.push_back(camera.opaqueDepth());
    }
    desc.targets.front().blend = {.enabled = true,
                                  .dstColor = rhi::BlendFactor::OneMinusSrcAlpha,
                                  .dstAlpha = rhi::BlendFactor::OneMinusSrcAlpha};
    if (coloured)
      desc.targets.front().blend = {.enabled = true,
                                    .dstColor = rhi::BlendFactor::Src1Color,
                                    .srcAlpha = rhi::BlendFactor::Zero,
                                    .dstAlpha = rhi::BlendFactor::One};
    m_byTriangle = context.knobs.is("sort", "triangle");
    const SceneView& view = context.view;
    if (m_byTriangle) {
      desc.constants.push_back({3, 1});
      m_triangles = TriangleOrder(
          context, [&view]() -> std::span<const uint32_t> { return view.effects().visibleTranslucent; },
          [&view](const glm::dvec3& centroid) { return -viewDepth(view, centroid); },
          std::move(bindings));
    } else {
      m_instances = backToFront(view, camera.translucent());
    }
    m_pipeline = context.pipeline(desc);
  }

  void moved(Frame& frame, CameraPass& camera) override {
    if (m_byTriangle)
      m_triangles.sort(frame.commands());
    else
      m_instances = backToFront(camera.view(), camera.translucent());
  }

  void record(Frame& frame, CameraPass& camera) override {
    camera.translucentPass(frame, "translucent", [&](rhi::CommandList& commands) {
      if (m_byTriangle)
        m_triangles.draw(commands, m_pipeline);
      else
        camera.drawList().draw(commands, m_pipeline, m_instances);
    });
  }

  void recordPart(Frame& frame, CameraPass& camera, std::span<const uint32_t> part) override {
    camera.translucentPass(frame, "translucent", [&](rhi::CommandList& commands) {
      camera.drawList().draw(commands, m_pipeline, part);
    });
  }

 private:
  bool m_byTriangle = false;
  rhi::PipelineId m_pipeline;
  std::vector<uint32_t> m_instances;
  TriangleOrder m_triangles;
};

REGISTER_TECHNIQUE(TransparencyTechnique, Sorted,
                   (TechniqueInfo{
                       .name = "Sorted",
                       .folder = "sorted",
                       .title = "Sorted alpha blending",
                       .paper = "Porter, Duff 1984; Modisett 2023",
                       .represents = {Effect::CameraTransparency, Effect::CameraLayers,
                                      Effect::ColouredTransparency},
                       .requiresFor = {{Effect::ColouredTransparency,
                                        rhi::Feature::DualSourceBlend}},
                       .knobs = {{.name = "sort",
                                  .help = "what is sorted back to front: whole meshes or triangles",
                                  .fallback = "mesh",
                                  .choices = {"mesh", "triangle"}}},
                       .error = "wrong order for large or intersecting surfaces",
                       .breaksIn = {{"camera crossing", "surfaces through one another have no order as wholes"}},
                       .drawsParts = [](const Knobs& knobs) { return knobs.is("sort", "mesh"); }}));

}  // namespace
}  // namespace sb
