// A camera that is set freely: frames that nobody waits for, in an order that is no path, are bit
// by bit the pictures of renderers prepared for each place alone; and nothing is made after
// preparing.
#include <set>

#include "suites/scenes/analysis/free_views.h"
#include "techniques/draw/frame/texels.h"
#include "tests/techniques/gpu_cell.h"
#include "tests/techniques/motion_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

constexpr rhi::Extent2D kShownSize = {48, 36};

Camera throughWideLens(Camera camera) {
  camera.fovY = 1.75;
  return camera;
}

/// Past everything (so that the first frame draws into no map), from outside, near, behind, and
/// through other lenses.
std::vector<Camera> cameraPlaces() {
  Camera parallel = lookAt({-3, 6, 2}, {0, 0.5, 0});
  parallel.orthographic = true;
  parallel.halfHeight = 2.5;
  return {lookAt({20, 5, 20}, {40, 10, 40}),
          lookAt({2.5, 3, 4}, {0, 0.25, 0}),
          lookAt({40, 30, -20}, {0, 0, 0}),
          lookAt({0.5, 1.25, 0.75}, {0, 1, 0}),
          lookAt({-2, 2, -5}, {0.5, 0.5, 0.5}),
          throughWideLens(lookAt({-4, 1, 3}, {2, 1, 0})),
          parallel,
          lookAt({4.5, 2.5, 3.5}, {3.5, 1, 2})};
}

rhi::Texture shownTexture(rhi::Device& device) {
  return device.createTexture({.label = "shown picture",
                               .format = CameraPass::kColorFormat,
                               .width = kShownSize.width,
                               .height = kShownSize.height,
                               .use = rhi::TextureUse::CopyTarget | rhi::TextureUse::CopySource |
                                      rhi::TextureUse::Sampled});
}

struct FreeCell {
  FreeCell(CellDevice& device, const Scene& s, const CellOptions& options)
      : scene(s),
        views(scene, double(kShownSize.width) / kShownSize.height, kShownSize.height),
        gpuScene(device.device, scene),
        renderer(device.context(), gpuScene, views.anywhere(), rendererDescOf(options)) {}
  Scene scene;
  FreeViews views;
  GpuScene gpuScene;
  Renderer renderer;
};

std::string nameOfCell(const CellOptions& options) {
  std::string name = options.technique + "+" + options.transparency;
  for (const auto& [knob, value] : options.knobs) name += " " + knob + "=" + value;
  return name;
}

CellOptions shownBy(const std::string& technique, std::map<std::string, std::string> knobs = {},
                    const std::string& transparency = "Sorted") {
  if (hasKnob(technique, "size")) knobs.insert({{"size", "96"}, {"kernel", "3"}});
  return {.technique = technique,
          .knobs = std::move(knobs),
          .size = kShownSize,
          .transparency = transparency};
}

/// `scene` moves along its path while the camera jumps; each place is shown twice.
void expectPicturesOfStandingCameras(rhi::Device& device, const Scene& scene,
                                     const CellOptions& options) {
  SCOPED_TRACE(nameOfCell(options));
  CellDevice& cells = cellDevice(device);
  FreeCell free(cells, scene, options);
  struct Shown {
    Camera camera;
    uint32_t step;
    rhi::Texture picture;
  };
  std::vector<Shown> shown;
  const uint32_t steps = std::max<uint32_t>(1, uint32_t(scene.path.size()));
  for (const Camera& camera : cameraPlaces())
    shown.push_back({camera, uint32_t(shown.size() * 3) % steps, shownTexture(device)});
  const auto memory = device.ledger().bytesByLabel();
  const size_t pipelines = cells.pipelines.size();
  rhi::Ticket last = 0;
  for (int round = 0; round < 2; ++round)
    for (const Shown& s : shown) {
      free.renderer.look({s.camera, free.views.from(s.camera, s.step), s.step});
      last = free.renderer.show([&](rhi::CommandList& commands, rhi::TextureId color) {
        commands.copy(rhi::TextureView{.texture = color},
                      rhi::TextureView{.texture = s.picture.id()});
      });
    }
  device.wait(last);
  EXPECT_EQ(device.ledger().bytesByLabel(), memory);
  EXPECT_EQ(cells.pipelines.size(), pipelines);
  // All but one, perhaps, show something of their own.
  std::set<std::vector<std::byte>> different;
  for (const Shown& s : shown) different.insert(device.read(s.picture));
  EXPECT_GE(different.size(), shown.size() - 1);
  for (size_t i = 0; i < shown.size(); ++i) {
    Scene alone = scene;
    if (!scene.path.empty()) alone = standingAt(scene, shown[i].step);
    alone.cameras.front() = shown[i].camera;
    Cell cell(cells, alone, options);
    EXPECT_EQ(halfToFloat(device.read(shown[i].picture)), cell.picture().rgba) << "place " << i;
  }
}

}  // namespace

GPU_TEST(FreeCamera, ShadowTechniquesShowWhatAStandingCameraSees) {
  for (const ShadowEntry* technique : shadowTechniques())
    expectPicturesOfStandingCameras(device(), furnished(true), shownBy(technique->info.name));
}

GPU_TEST(FreeCamera, TransparencyTechniquesShowWhatAStandingCameraSees) {
  for (const TransparencyEntry* technique : transparencyTechniques())
    expectPicturesOfStandingCameras(device(), furnished(false),
                                    shownBy("ShadowMap", {}, technique->info.name));
  expectPicturesOfStandingCameras(device(), furnished(false),
                                  shownBy("ShadowMap", {{"sort", "triangle"}}));
}

GPU_TEST(FreeCamera, TrianglesMayAlternateWhereTheOverviewSortsMeshByMesh) {
  // The fifth place looks straight at two boxes beside each other and meets a triangle of each by
  // turns; from above, all of one lie before the other.
  Scene scene = furnished(false);
  const glm::vec3 gaze = glm::normalize(glm::vec3(2.5f, -1.5f, 5.5f));
  const glm::vec3 aside = glm::normalize(glm::vec3(1.5f, 2.5f, 0));
  const glm::vec3 first(-0.5f, 0.5f, 0), second = first + 2.0f * aside + 0.01f * gaze;
  const uint32_t pane = add(scene, glass(0.5f, {0.5f, 1, 0.25f}));
  for (const glm::vec3& low : {first, second}) addBox(scene, pane, low, low + 0.5f);
  expectPicturesOfStandingCameras(device(), scene, shownBy("none", {{"sort", "triangle"}}));
}

GPU_TEST(FreeCamera, OrdersAndPartitionsFollowTheCamera) {
  for (const char* order : {"nearest", "triangle"})
    expectPicturesOfStandingCameras(
        device(), furnished(true),
        shownBy("TranslucentShadows", {{"variant", "published"}, {"order", order}}));
  for (const char* partition : {"peeled", "batches", "source"})
    expectPicturesOfStandingCameras(device(), furnished(true),
                                    shownBy("CompositedTranslucent", {{"partition", partition}}));
  expectPicturesOfStandingCameras(device(), furnished(true),
                                  shownBy("CompositedTranslucent", {{"levels", "2"}}));
}

GPU_TEST(FreeCamera, VolumesThatEndAtTheEyeAreCountedBehindIt) {
  // The third place stands in the shadow of this box, which none of the others does.
  Scene scene = furnished(false);
  addBox(scene, add(scene, matte()), {-1.6f, 4, 0.5f}, {0.4f, 4.5f, 2.5f});
  for (const char* build : {"cpu", "vertex", "geometry", "compute"})
    expectPicturesOfStandingCameras(device(), scene,
                                    shownBy("StencilShadowVolume", {{"build", build}}));
}

GPU_TEST(FreeCamera, PenumbraeAreThoseOfAStandingCamera) {
  expectPicturesOfStandingCameras(device(), withSoftLights(inhabited(true)),
                                  shownBy("PenumbraWedge"));
}

GPU_TEST(FreeCamera, BeforeItIsSetEverythingIsSeen) {
  for (const ShadowEntry* technique : shadowTechniques()) {
    FreeCell free(cellDevice(device()), furnished(true), shownBy(technique->info.name));
    free.renderer.frame();
    const std::vector<float> picture = free.renderer.readImage();
    EXPECT_TRUE(std::ranges::any_of(picture, [](float v) { return v > 0 && v < 1; }))
        << technique->info.name;
  }
}

GPU_TEST(FreeCamera, TheWorldMovesOn) {
  for (const ShadowEntry* technique : shadowTechniques())
    expectPicturesOfStandingCameras(device(), inhabited(true), shownBy(technique->info.name));
}
