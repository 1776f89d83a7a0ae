// Decision D5 on the committed scenes: Vulkan and OpenGL, OSMesa and EGL, one run and the next.
// Depth and colour maps bit-identical across APIs, pictures within one step of 255 on every pixel;
// OSMesa equal to EGL and every run equal to the last, bit by bit.
#include "suites/harness/checks/verify.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/techniques/gpu_cell.h"

namespace sb::test {
namespace {

struct Made {
  report::Picture picture;
  std::vector<float> depth, colours;
};

const std::vector<std::string> kScenes = {"layers:resolution=64", "spheres_quads:quads=100",
                                          "window", "teapot:segments=4"};

/// "CSSM2", or with a knob: "CSSM2 msaa=4".
CellOptions optionsOf(const std::string& text) {
  CellOptions options{.technique = text.substr(0, text.find(' ')), .size = {128, 96}};
  if (const size_t space = text.find(' '); space != text.npos) {
    const size_t equals = text.find('=');
    options.knobs[text.substr(space + 1, equals - space - 1)] = text.substr(equals + 1);
  }
  return options;
}

/// A picture and its maps, made twice and found equal.
Made make(rhi::Device& device, const std::string& technique, const std::string& scene) {
  Made made;
  for (int run = 0; run < 2; ++run) {
    Cell cell(cellDevice(device), makeScene(scene), optionsOf(technique));
    Made now{cell.picture(), {}, {}};
    if (cell.hasMap("depth")) now.depth = cell.map("depth");
    if (cell.hasMap("colours")) now.colours = cell.map("colours");
    if (technique.starts_with("CSSM1") && cell.hasMap("depth")) now.colours = cell.map("depth", 2);
    cell.renderAgain();
    EXPECT_EQ(now.picture.rgba, cell.picture().rgba) << "frame to frame: " << scene;
    if (run == 1) {
      EXPECT_EQ(now.picture.rgba, made.picture.rgba) << "run to run: " << scene;
      EXPECT_EQ(now.depth, made.depth) << "run to run: " << scene;
      EXPECT_EQ(now.colours, made.colours) << "run to run: " << scene;
    }
    made = std::move(now);
  }
  return made;
}

size_t differing(const std::vector<float>& a, const std::vector<float>& b) {
  size_t n = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) n += a[i] != b[i];
  return n + std::max(a.size(), b.size()) - std::min(a.size(), b.size());
}

class Pictures : public testing::TestWithParam<std::string> {};

TEST_P(Pictures, AgreeAcrossBackends) {
  std::map<std::string, rhi::Device*> devices;
  for (const std::string& backend : gpuBackends())
    if (rhi::Device* device = sharedDevice(backend)) devices[backend] = device;
  if (devices.size() < 2) GTEST_SKIP() << "fewer than two backends start";
  for (const std::string& scene : kScenes) {
    SCOPED_TRACE(scene);
    std::map<std::string, Made> made;
    for (const auto& [backend, device] : devices)
      made.emplace(backend, make(*device, GetParam(), scene));
    const Made& first = made.begin()->second;
    for (const auto& [backend, other] : made) {
      EXPECT_EQ(differing(first.depth, other.depth), 0u) << backend;
      EXPECT_EQ(differing(first.colours, other.colours), 0u) << backend;
      EXPECT_EQ(pixelsBeyondOneStep(first.picture, other.picture), 0u)
          << backend << ", at most by " << maxDifference255(first.picture, other.picture);
    }
    // A picture without content would agree too.
    const auto [low, high] = std::ranges::minmax_element(first.picture.rgba);
    EXPECT_GT(*high - *low, 0.5f);
    if (!first.depth.empty()) {
      EXPECT_LT(*std::ranges::min_element(first.depth), 1);
    }
    if (made.contains("opengl") && made.contains("opengl-osmesa")) {
      EXPECT_EQ(made["opengl"].picture.rgba, made["opengl-osmesa"].picture.rgba);
    }
  }
  for (const auto& [backend, device] : devices)
    for (const rhi::Message& m : device->takeMessages())
      ADD_FAILURE() << backend << ": " << m.source << " [" << m.rule << "] " << m.text;
}

INSTANTIATE_TEST_SUITE_P(Together, Pictures,
                         testing::Values("ShadowMap", "StochasticShadowMap", "CSSM1", "CSSM2",
                                         "StochasticShadowMap msaa=4", "CSSM1 msaa=4",
                                         "CSSM2 msaa=4", "CSSM2 noise=texture",
                                         "CSSM2 noise=stratified", "CSSM2 noise=blue"));

}  // namespace
}  // namespace sb::test
