// The third question: which lights may reach a point. A loop that only tests know takes the lights
// from a list that it makes in a pass of its own, the last one first.
#include "backends/shader/compile.h"
#include "base/worst.h"
#include "shaders/common/shared_slots.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "tests/techniques/gpu_cell.h"

using namespace sb;
using namespace sb::test;

namespace {

/// Lists some of the lights in view.
class Backwards final : public LightTechnique {
 public:
  explicit Backwards(std::vector<uint32_t> lights) : m_lights(std::move(lights)) {}

  void prepare(const Context& context) override {
    m_list =
        context.device.createBuffer({.label = "light list",
                                     .size = m_lights.size() * 4,
                                     .use = rhi::BufferUse::Storage | rhi::BufferUse::CopyTarget});
  }
  void record(Frame& frame) override {
    frame.between("list lights", PassGroup::Scene, [&](rhi::CommandList& commands) {
      commands.write(m_list, 0, std::as_bytes(std::span(m_lights)));
    });
  }
  VisibilityInputs inputs() const override {
    return {.bindings = {rhi::storageAt(STORAGE_LIGHT_LOOP, m_list)}, .reads = {}, .constants = {}};
  }

 private:
  std::vector<uint32_t> m_lights;
  rhi::Buffer m_list;
};

LightsEntry backwards(std::vector<uint32_t> lights) {
  return {{.name = "Backwards", .folder = "backwards"},
          [lights] { return std::make_unique<Backwards>(lights); }};
}

/// The program's shaders, and the one of ShadowMap with that loop.
const rhi::ShaderLibrary& shadersWithLoop() {
  static const rhi::ShaderLibrary library = [] {
    rhi::ShaderLibrary lib = productionShaders();
    const std::filesystem::path root = SHADOWBENCH_SOURCE_DIR;
    lib.add(shader::compile({.name = "shadow_map@backwards/forward.frag",
                             .root = root / "shaders",
                             .file = "templates/forward.frag.glsl",
                             .stage = rhi::ShaderStage::Fragment,
                             .aliases = {{"technique", "shadow_map"}, {"lights", "backwards"}},
                             .include = root / "tests/techniques/light_loops"}));
    return lib;
  }();
  return library;
}

std::vector<float> picture(rhi::Device& device, const Scene& scene, const LightsEntry* lights) {
  CellDevice& shared = cellDevice(device);
  const rhi::Extent2D size{48, 48};
  RendererDesc desc = rendererDesc(
      {.technique = "ShadowMap", .knobs = {{"size", "128"}}, .width = 48, .height = 48});
  if (lights) desc.lights = lights;
  Stage stage(scene, size);
  const DeviceContext context{device, shadersWithLoop(), shared.pipelines, shared.queries};
  const auto renderer = stage.renderer(context, desc);
  renderer->frame();
  return renderer->readImage();
}

float largest(const std::vector<float>& a, const std::vector<float>& b) {
  float most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = base::worse(most, std::abs(a[i] - b[i]));
  return most;
}

}  // namespace

GPU_TEST(LightLoops, APlugInGivesShadersItsOwnLoop) {
  Scene scene = floorScene(false);
  addBox(scene, 0, {-1, 0.1f, -1}, {1, 0.3f, 1});
  scene.cameras[0] = lookAt({1, 6, 5}, {0, 0, 0}, 0.9);
  addLight(scene, pointLight({2, 3, 1}, 8));
  addLight(scene, sun({0.5, -1, 0.2}));
  addLight(scene, pointLight({-2, 2, -1}, 5));
  const auto all = picture(device(), scene, nullptr);
  const LightsEntry same = backwards({0, 1, 2}), fewer = backwards({0, 2});
  EXPECT_LE(largest(all, picture(device(), scene, &same)), 0x1p-9f);
  // What the loop leaves out is dark: the picture without that light.
  Scene without = scene;
  without.lights.erase(without.lights.begin() + 1);
  EXPECT_GT(largest(all, picture(device(), scene, &fewer)), 0.1f);
  EXPECT_LE(largest(picture(device(), without, nullptr), picture(device(), scene, &fewer)),
            0x1p-9f);
}
