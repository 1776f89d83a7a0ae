// Per-pixel linked lists (Yang, Hensley, Gruen, Thibieroz 2010); spec 15, E. Each surface is shaded
// once and its fragments are put into lists, one a pixel; a full-screen pass sorts them by depth
// and persistent key and composes them. Two passes; 16 or 20 bytes a fragment, 4 more where the
// scene has glass and each channel of what lies behind a weight. The `layers` nearest
// are exact, coplanar ones too; the rest of a pixel is mixed by weight alone. The pool holds as
// many fragments as were counted when it was made; beyond a smaller one that is asked for, or
// beyond what the device allows, they are dropped, counted and reported. nodes=rgba8 clamps colours
// to 1 and shows bands where little comes through.
#include <algorithm>
#include <cstring>

#include "shaders/common/shared_slots.h"
#include "techniques/draw/pass_queries.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

constexpr uint32_t kEndOfList = 0xFFFFFFFFu;

class LinkedLists final : public TransparencyTechnique {
 public:
  void prepare(const Context& context, CameraPass& camera) override {
    m_device = &context.device;
    const bool half = context.knobs.is("nodes", "rgba16f");
    m_coloured = context.plan.runs(Effect::ColouredTransparency);
    const uint64_t perPixel = context.knobs.integer("pool");
    const auto [width, height] = context.view.size();
    createBuffers(context, (half ? 20 : 16) + (m_coloured ? 4 : 0),
                  perPixel > 0 ? perPixel * width * height : countFragments(context, camera));

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
    std::vector<rhi::Binding> lists = {rhi::storageAt(STORAGE_TRANSPARENCY, m_heads),
                                       rhi::storageAt(STORAGE_TRANSPARENCY + 1, m_nodes),
                                       rhi::storageAt(STORAGE_TRANSPARENCY + 2, m_asked)};
    m_bindings.insert(m_bindings.end(), lists.begin(), lists.end());
    if (camera.coplanar()) lists.push_back(camera.opaqueDepth());
    m_draws = camera.drawListWith(lists);
  }

  void record(Frame& frame, CameraPass& camera) override {
    frame.commands().fill(m_heads, 0, m_headBytes, kEndOfList);
    frame.commands().fill(m_asked, 0, 4, 0);
    const rhi::ResourceUse writes[] = {rhi::use(m_heads.id(), rhi::Access::StorageWrite),
                                       rhi::use(m_nodes.id(), rhi::Access::StorageWrite),
                                       rhi::use(m_asked.id(), rhi::Access::StorageWrite)};
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
    const rhi::ResourceUse reads[] = {rhi::use(m_heads.id(), rhi::Access::StorageRead),
                                      rhi::use(m_nodes.id(), rhi::Access::StorageRead)};
    camera.compositePass(frame, "sort and composite", reads, [&](rhi::CommandList& commands) {
      drawFullscreen(commands, m_resolve, m_bindings);
    });
    m_recorded = true;
  }

  std::vector<std::string> warnings() override {
    if (!m_recorded) return {};
    uint32_t asked = 0;
    std::memcpy(&asked, m_device->read(m_asked, 0, 4).data(), 4);
    if (asked <= m_capacity) return {};
    return {"linked lists dropped " + std::to_string(asked - m_capacity) + " of " +
            std::to_string(asked) + " fragments: the pool holds " + std::to_string(m_capacity) +
            " (knob pool)"};
  }

 private:
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
                              .depth = rhi::DepthAttachment{.view = {.texture = camera.depth()}}});
      query.count(commands, [&] { draws.draw(commands, pipeline, camera.translucent()); });
    }
    frame.endAndWait();
    return query.take().front();
  }

  void createBuffers(const Context& context, uint64_t nodeBytes, uint64_t wanted) {
    const auto [width, height] = context.view.size();
    const uint64_t pixels = uint64_t(width) * height;
    // A smaller pool than asked for shows in the count of what was dropped.
    m_capacity = std::min(wanted, context.device.info().limits.maxStorageRange / nodeBytes);
    m_headBytes = pixels * 4;
    auto buffer = [&](const char* label, uint64_t size) {
      return context.device.createBuffer({.label = label,
                                          .size = size,
                                          .use = rhi::BufferUse::Storage |
                                                 rhi::BufferUse::CopyTarget |
                                                 rhi::BufferUse::CopySource});
    };
    m_heads = buffer("list heads", m_headBytes);
    m_nodes = buffer("list nodes", m_capacity * nodeBytes);
    m_asked = buffer("list counter", 16);
  }

  rhi::Device* m_device = nullptr;
  bool m_coloured = false;
  uint64_t m_capacity = 0;  ///< nodes
  uint64_t m_headBytes = 0;
  bool m_recorded = false;
  rhi::Buffer m_heads, m_nodes, m_asked;
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
