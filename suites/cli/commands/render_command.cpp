// bench render: the picture of one cell as PNG and linear EXR, and its visibility buffer.
#include "reports/picture.h"
#include "suites/cli/commands/commands.h"
#include "suites/cli/memory.h"
#include "suites/cli/output_files.h"
#include "suites/cli/say.h"
#include "suites/cli/visibility_files.h"
#include "suites/harness/checks/verify.h"
#include "suites/harness/stage.h"
#include "suites/metrics/exposure.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

/// One cell; on the first default backend that starts when none is named.
CellId oneCell(const Options& options, const Platform& platform, Devices& devices) {
  Selection selection = options.selection;
  if (selection.techniques.empty()) selection.techniques = {"CSSM2"};
  for (const std::string& name : selection.techniques)
    if (isReference(parseTechniques(name)))
      throw InputError("--technique", "found " + name + ", which `bench truth` traces: `render` is "
                                      "for what draws on a device");
  if (selection.scenes.empty()) selection.scenes = {"layers"};
  std::vector<std::string> candidates = defaultBackends(options);
  if (selection.backends.empty()) selection.backends = {candidates.front()};
  auto cells = selectCells(selection, platform.names(), {});
  if (cells.size() != 1)
    throw InputError("render",
                     "found " + std::to_string(cells.size()) +
                         " cells, expected one technique, backend, scene and value a knob");
  if (!options.selection.backends.empty()) candidates = {cells.front().backend};
  std::string why;
  for (const std::string& backend : candidates) {
    cells.front().backend = backend;
    if (devices.open(backend)) return cells.front();
    const std::string text = "backend " + backend + " does not start: " + devices.why(backend);
    if (candidates.size() > 1) say(text);
    why += (why.empty() ? "" : "; ") + text;
  }
  if (const std::string unknown = devices.whyNoSuchDevice(); !unknown.empty())
    throw InputError("--device", unknown);
  throw rhi::Error("render", "", why);
}

void writeDrawnVisibility(const Options& options, Renderer& renderer, rhi::Extent2D size) {
  std::vector<std::pair<uint32_t, std::vector<VisibilityImage>>> lights;
  for (const uint32_t light : renderer.lights())
    lights.emplace_back(light, renderer.readVisibility(light));
  VisibilityLayers layers;
  for (const auto& [light, images] : lights)
    for (uint32_t layer = 0; layer < images.size(); ++layer)
      layers[{light, layer}] = &images[layer];
  writeVisibility(options.picture.prefix, size, std::move(layers));
}

}  // namespace

int renderCommand(const Options& options) {
  limitMemory(options);
  Platform platform = makePlatform(options);
  Devices devices(platform.backends(), platform.shaders,
                  {.selector = options.device.selector, .validate = options.device.validate});
  const CellId id = oneCell(options, platform, devices);
  DeviceSession* session = devices.open(id.backend);
  const Scene scene = makeScene(id.scene);
  for (const std::string& w : scene.warnings) say(w);
  requireOutputs(options, scene);
  requireMemory(scene, {id.width, id.height},
                options.picture.visibility ? Made::VisibilityFiles : Made::Picture);
  Stage stage(scene, {id.width, id.height});
  if (auto skip = stage.unsupported(*session->device, rendererDesc(id)))
    throw rhi::Error("render", "", cellName(id) + ": " + skip->reason);
  const auto renderer = stage.renderer(session->context(), rendererDesc(id));
  renderer->standStill();
  renderer->frame();
  const report::Picture picture{id.width, id.height, renderer->readImage()};
  if (const uint64_t bad = countNonFinite(picture))
    say("warning: " + std::to_string(bad) + " values of the picture are not finite");
  report::writePng(options.picture.prefix + ".png", picture,
                   options.exposure.value_or(automaticExposure(picture)));
  report::writeExr(options.picture.prefix + ".exr", picture);
  print(options.picture.prefix + ".png " + options.picture.prefix + ".exr\n");
  if (options.picture.visibility) writeDrawnVisibility(options, *renderer, {id.width, id.height});
  int code = 0;
  for (const rhi::Message& m : session->device->takeMessages()) {
    say(m.source + " [" + m.rule + "] " + m.text);
    code = 1;
  }
  return code;
}

}  // namespace sb
