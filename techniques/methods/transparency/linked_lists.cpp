// Per-pixel linked lists (Yang, Hensley, Gruen, Thibieroz 2010); spec 15, E. Each surface is shaded
// once and its fragments are put into lists, one a pixel; a full-screen pass sorts them by depth
// and persistent key and composes them. Two passes; 16 or 20 bytes a fragment, 4 more where the
// scene has glass and each channel of what lies behind a weight. The `layers` nearest
// are exact, coplanar ones too; the rest of a pixel is mixed by weight alone. The pool holds as
// many fragments as were counted when it was made; beyond a smaller one that is asked for, or
// beyond what the device allows, they are dropped, counted and reported; for a camera that is set
// freely it holds `layers` a pixel on average. nodes=rgba8 clamps colours
// to 1 and shows bands where little comes through.
#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/draw/frame/pass_queries.h"
#include "techniques/lists/list_pool.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

class LinkedLists final : public TransparencyTechnique {
 public:
  void prepare(const Context& context, CameraPass& camera) override {
    const bool half = context.knobs.is("nodes", "rgba16f");
    m_coloured = context.plan.runs(Effect::ColouredTransparency);
    const uint64_t perPixel = context.knobs.integer("pool");
    const auto [width, height] = context.view.size();
    const uint64_t pixels = uint64_t(width) * height;
    m_pool = ListPool(context.device, pixels, (half ? 5 : 4) + (m_coloured ? 1 : 0),
                      perPixel > 0            ? perPixel * pixels
                      : context.view.isFree() ? pixels * sortedEverywhere(context, camera)
                                              : countFragments(context, camera));

    std::string folder = m_coloured ? "linked_lists/coloured" : "linked_lists";
    if (camera.coplanar()) folder += "/coplanar";
    rhi::GraphicsPipelineDesc build = camera.translucentPipeline(folder);
    if (camera.coplanar()) {
      build.depth = {};
      build.depthFormat = rhi::Format::Undefined;
    }
    build.targets.clear();
    build.constants.push_back({32, half});
    m_build = context.pipeline(build);
    rhi::GraphicsPipelineDesc resolve =
        m_coloured ? camera.colouredCompositePipeline("linked_lists/coloured/resolve.frag")
                   : camera.compositePipeline("linked_lists/resolve.frag");
    resolve.constants = {{32, half}, {33, context.knobs.integer("layers")}};
    m_resolve = context.pipeline(resolve);

    m_bindings = context.view.bindings();
    const auto pool = m_pool.bindings(STORAGE_TRANSPARENCY);
    m_bindings.insert(m_bindings.end(), pool.begin(), pool.end());
    std::vector<rhi::Binding> lists(pool.begin(), pool.end());
    if (camera.coplanar()) lists.push_back(camera.opaqueDepth());
    m_draws = camera.drawListWith(lists);
  }

  void record(Frame& frame, CameraPass& camera) override {
    m_pool.clear(frame.commands());
    const auto writes = m_pool.writes();
    rhi::PassDesc lists{.label = "lists", .writes = writes};
    const rhi::ResourceUse depth = rhi::use(camera.depth(), rhi::Access::Sampled);
    lists.extent = camera.view().size();
    if (camera.coplanar())
      lists.reads = {&depth, 1};
    else
      lists.depth = rhi::DepthAttachment{
          .view = {.texture = camera.depth()}, .load = rhi::LoadOp::Load, .readOnly = true};
    camera.surfacePass(
        frame, lists,
        [&](rhi::CommandList& commands) { m_draws.draw(commands, m_build, camera.translucent()); });
    const auto reads = m_pool.reads();
    camera.compositePass(frame, "sort and composite", reads, [&](rhi::CommandList& commands) {
      drawFullscreen(commands, m_resolve, m_bindings);
    });
  }

  std::vector<std::string> warnings() override {
    const auto overflow = m_pool.overflow();
    if (!overflow) return {};
    return {"linked lists dropped " + std::to_string(overflow->dropped) + " of " +
            std::to_string(overflow->asked) + " fragments: the pool holds " +
            std::to_string(m_pool.capacity()) + " (knob pool)"};
  }

 private:
  /// Fragments a pixel for a camera that is set freely, whose fragments nobody can count beforehand:
  /// on average as many as are sorted, or as there are triangles.
  static uint64_t sortedEverywhere(const Context& context, const CameraPass& camera) {
    const Scene& scene = context.view.scene();
    uint64_t triangles = 1;
    for (const uint32_t i : camera.translucent())
      triangles += scene.meshes[scene.instances[i].mesh].triangleCount();
    return std::min<uint64_t>(triangles, context.knobs.integer("layers"));
  }

  /// Fragments of all translucent surfaces, those behind opaque ones included: no more can come.
  /// Of a camera in motion: at the step that has most.
  uint64_t countFragments(const Context& context, const CameraPass& camera) const {
    uint64_t most = 1;
    context.view.alongPath(context.device,
                           [&] { most = std::max(most, countNow(context, camera)); });
    return most;
  }

  uint64_t countNow(const Context& context, const CameraPass& camera) const {
    PassQueries query(context.device, "list fragments", 1);
    rhi::GraphicsPipelineDesc desc = camera.translucentPipeline("linked_lists");
    desc.fragment = nullptr;
    desc.targets.clear();
    desc.constants.clear();
    const rhi::PipelineId pipeline = context.pipeline(desc);
    DrawList draws = camera.drawListWith({});
    rhi::FrameScope frame(context.device);
    rhi::CommandList& commands = frame.commands();
    {
      rhi::PassScope pass =
          commands.beginPass({.label = "list fragments",
                              .depth = rhi::DepthAttachment{.view = {.texture = camera.depth()},
                                                            .clearDepth = CameraPass::kFarDepth}});
      query.count(commands, [&] { draws.draw(commands, pipeline, camera.translucent()); });
    }
    frame.endAndWait();
    return query.take().front();
  }

  bool m_coloured = false;
  ListPool m_pool;
  rhi::PipelineId m_build, m_resolve;
  std::vector<rhi::Binding> m_bindings;
  DrawList m_draws;
};

REGISTER_TECHNIQUE(
    TransparencyTechnique, LinkedLists,
    (TechniqueInfo{
        .name = "LinkedLists",
        .folder = "linked_lists",
        .title = "Per-pixel linked lists, sorted",
        .paper = "Yang, Hensley, Gruen, Thibieroz 2010",
        .represents = {Effect::CameraTransparency, Effect::CameraLayers,
                       Effect::ColouredTransparency},
        .requires_ = {rhi::Feature::FragmentStoresAndAtomics, rhi::Feature::PreciseOcclusion},
        .requiresFor = {{Effect::ColouredTransparency, rhi::Feature::DualSourceBlend}},
        .knobs = {{.name = "layers",
                   .help = "nearest layers that are sorted; the rest is averaged",
                   .fallback = "16",
                   .choices = {"8", "16", "32", "64"},
                   .sweep = {"8", "16", "32"}},
                  {.name = "nodes",
                   .help = "format of a fragment's colour",
                   .fallback = "rgba16f",
                   .choices = {"rgba8", "rgba16f"},
                   .sweep = {"rgba8", "rgba16f"}},
                  {.name = "pool",
                   .unit = "fragments/pixel",
                   .help = "size of the pool of nodes, on average over the picture; "
                           "0: as many as there are, counted beforehand",
                   .fallback = "0",
                   .min = 0,
                   .max = 256}},
        .error = "none up to the number of layers; the average of deeper ones",
        .breaksIn = {{"camera layers", "layers behind the nearest `layers` are averaged"},
                     {"camera 0/1 nodes:rgba8", "colours are rounded to 8 bits"}}}));

}  // namespace
}  // namespace sb
