// bench render: the picture of one cell as PNG and linear EXR, and its visibility buffer.
#include "reports/picture.h"
#include "suites/cli/commands.h"
#include "suites/cli/memory.h"
#include "suites/cli/say.h"
#include "suites/harness/verify.h"
#include "suites/metrics/exposure.h"
#include "suites/scenes/analysis.h"
#include "suites/scenes/procedural.h"
#include "techniques/common/error.h"

namespace sb {
namespace {

void writeBoth(const std::string& prefix, const report::Picture& picture, float exposure) {
  report::writePng(prefix + ".png", picture, exposure);
  report::writeExr(prefix + ".exr", picture);
  print(prefix + ".png " + prefix + ".exr\n");
}

/// One cell; on the first default backend that starts when none is named.
CellId oneCell(const Options& options, const Platform& platform, Devices& devices) {
  Selection selection = options.selection;
  if (selection.techniques.empty()) selection.techniques = {"CSSM2"};
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

void requireWritable(const Options& options) {
  for (const char* extension : {".png", ".exr"})
    sb::requireWritable("--output", options.outputPrefix + extension);
}

}  // namespace

int renderCommand(const Options& options) {
  limitMemory(options);
  Platform platform = makePlatform(options);
  requireWritable(options);
  Devices devices(platform.backends(), platform.shaders,
                  {.selector = options.device, .validate = options.validate});
  const CellId id = oneCell(options, platform, devices);
  DeviceSession* session = devices.open(id.backend);
  const TechniqueInfo& technique = shadowTechnique(id.technique).info;
  const Scene scene = makeScene(id.scene);
  for (const std::string& w : scene.warnings) say(w);
  requireMemory(scene, {id.width, id.height}, false);
  const Effects effects = analyse(scene, double(id.width) / double(id.height));
  if (auto skip =
          unsupported(*session->device, technique, transparencyTechnique(id.transparency).info,
                      cellKnobs(id), effects.present))
    throw rhi::Error("render", "", cellName(id) + ": " + skip->reason);
  const GpuScene gpuScene(*session->device, scene);
  Renderer renderer(session->context(), gpuScene, effects,
                    {.technique = &shadowTechnique(id.technique),
                     .transparency = &transparencyTechnique(id.transparency),
                     .knobs = cellKnobs(id),
                     .size = {id.width, id.height},
                     .seed = id.seed,
                     .forced = {}});
  renderer.standStill();
  renderer.frame();
  const report::Picture picture{id.width, id.height, renderer.readImage()};
  if (const uint64_t bad = countNonFinite(picture))
    say("warning: " + std::to_string(bad) + " values of the picture are not finite");
  writeBoth(options.outputPrefix, picture,
            options.exposure.value_or(automaticExposure(picture)));
  if (options.visibility)
    for (uint32_t light = 0; light < renderer.lightCount(); ++light) {
      const auto layers = renderer.readVisibility(light);
      for (size_t layer = 0; layer < layers.size(); ++layer)
        writeBoth(options.outputPrefix + ".visibility.light" + std::to_string(light) +
                      (layer == 0 ? ".opaque" : ".layer" + std::to_string(layer)),
                  {id.width, id.height, layers[layer]}, 1);
    }
  int code = 0;
  for (const rhi::Message& m : session->device->takeMessages()) {
    say(m.source + " [" + m.rule + "] " + m.text);
    code = 1;
  }
  return code;
}

}  // namespace sb
