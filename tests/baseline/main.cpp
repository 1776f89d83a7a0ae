// What the interface, and what this program does above it, costs: the frame of a cell drawn by us
// and straight through the API, in turns. The pictures must be the same bits; the times are
// printed, and nothing is asserted of them (a frame's CPU time varies by several per cent).
//   baseline vulkan|opengl [QUADS] [PAIRS]
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <glm/gtc/packing.hpp>

#include "backends/opengl/device/gl_backend.h"
#include "backends/vulkan/device/vk_backend.h"
#include "suites/harness/stage.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/baseline/by_hand.h"

namespace shadowbench_shader_blob {
void addTo(rhi::ShaderLibrary& library);
}

namespace {

using namespace sb;

double cpuMs(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

struct Times {
  std::vector<double> calls;  ///< this thread, until submission returns
  std::vector<double> total;  ///< all threads, until the frame is complete

  template <class Submit, class Wait>
  void measure(Submit&& submit, Wait&& wait) {
    const double thread = cpuMs(CLOCK_THREAD_CPUTIME_ID);
    const double process = cpuMs(CLOCK_PROCESS_CPUTIME_ID);
    submit();
    calls.push_back(cpuMs(CLOCK_THREAD_CPUTIME_ID) - thread);
    wait();
    total.push_back(cpuMs(CLOCK_PROCESS_CPUTIME_ID) - process);
  }
};

double median(std::vector<double> v) {
  std::ranges::sort(v);
  return v[v.size() / 2];
}

void tell(const char* what, const std::vector<double>& ours, const std::vector<double>& byHand) {
  std::vector<double> ratios;
  for (size_t i = 0; i < ours.size(); ++i) ratios.push_back(ours[i] / byHand[i]);
  std::printf("%-32s ours %8.2f ms, by hand %8.2f ms, ratio of pairs %.3f\n", what, median(ours),
              median(byHand), median(ratios));
}

int run(const std::string& api, const std::string& quads, int pairs) {
  rhi::ShaderLibrary shaders;
  shadowbench_shader_blob::addTo(shaders);
  const Scene scene = makeScene("spheres_quads:quads=" + quads);
  const rhi::Extent2D size{512, 512};
  const baseline::Capture capture = baseline::captureShadowMap(scene, shaders, size);
  const auto byHand =
      api == "vulkan" ? baseline::makeVulkan(capture) : baseline::makeOpengl(capture);

  const auto backend =
      api == "vulkan" ? vulkan::makeBackend() : opengl::makeBackend(opengl::ContextKind::Egl);
  const auto device = backend->open({});
  PipelineCache pipelines(*device);
  FrameQueries queries(*device);
  Stage stage(scene, size);
  const auto renderer = stage.renderer(
      {*device, shaders, pipelines, queries},
      rendererDesc({.technique = "ShadowMap", .width = size.width, .height = size.height}));
  auto drawByHand = [&](Times& times) {
    times.measure([&] { byHand->submit(); }, [&] { byHand->wait(); });
  };
  Times ours, theirs, warm;
  auto drawOurs = [&](Times& times) {
    const FrameResult frame = renderer->frame();
    times.calls.push_back(frame.callsMs);
    times.total.push_back(frame.cpuMs);
  };
  for (int i = 0; i < 3; ++i) drawByHand(warm), drawOurs(warm);
  for (int i = 0; i < pairs; ++i) {
    if (i % 2 == 0) drawByHand(theirs);
    drawOurs(ours);
    if (i % 2 != 0) drawByHand(theirs);
  }
  std::printf("%s, ShadowMap, spheres_quads:quads=%s, %ux%u, %d pairs\n", api.c_str(),
              quads.c_str(), size.width, size.height, pairs);
  tell("recording and submitting (CPU)", ours.calls, theirs.calls);
  tell("whole frame (CPU, all threads)", ours.total, theirs.total);

  const std::vector<float> a = renderer->readImage();
  const std::vector<std::byte> b = byHand->picture();
  size_t differing = 0, lit = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    uint16_t half;
    std::memcpy(&half, b.data() + 2 * i, 2);
    const float value = glm::unpackHalf1x16(half);
    differing += std::memcmp(&value, &a[i], 4) != 0;
    lit += i % 4 != 3 && value > 0;
  }
  std::printf("%zu of %zu values of the pictures differ\n", differing, a.size());
  return differing == 0 && lit > a.size() / 4 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string api = argc > 1 ? argv[1] : "";
  if (api != "vulkan" && api != "opengl") {
    std::fprintf(stderr, "usage: baseline vulkan|opengl [QUADS] [PAIRS]\n");
    return 2;
  }
  return run(api, argc > 2 ? argv[2] : "2000", argc > 3 ? std::atoi(argv[3]) : 20);
}
