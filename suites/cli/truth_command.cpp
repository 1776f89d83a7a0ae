// bench truth: the ray-traced reference of a scene as pictures. bench cache: the truths on disk.
#include <atomic>
#include <csignal>
#include <cstdio>

#include "reports/picture.h"
#include "suites/cli/commands.h"
#include "suites/cli/progress.h"
#include "suites/harness/scene_hash.h"
#include "suites/harness/selection.h"
#include "suites/scenes/procedural.h"
#include "suites/truth/tracer.h"
#include "suites/truth/truth_cache.h"
#include "techniques/common/error.h"

namespace sb {
namespace {

std::atomic<bool> g_interrupted = false;

void write(const std::string& prefix, const report::Picture& picture, float exposure) {
  report::writePng(prefix + ".png", picture, exposure);
  report::writeExr(prefix + ".exr", picture);
  std::printf("%s.png %s.exr\n", prefix.c_str(), prefix.c_str());
}

void writeAll(const Options& options, const Scene& scene, const Truth& truth) {
  const auto picture = [&](const std::vector<float>& rgba) {
    return report::Picture{truth.width, truth.height, rgba};
  };
  write(options.outputPrefix, picture(truth.image), options.exposure);
  for (size_t light = 0; light < scene.lights.size(); ++light)
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer)
      write(options.outputPrefix + ".visibility.light" + std::to_string(light) +
                (layer == 0 ? ".opaque" : ".layer" + std::to_string(layer)),
            picture(truth.visibility[light * kTruthLayers + layer]), 1);
  std::vector<float> edges;
  for (const uint8_t e : truth.imageEdges) edges.insert(edges.end(), {float(e), float(e), float(e), 1});
  report::writePng(options.outputPrefix + ".edges.png", picture(edges));
  std::printf("%s.edges.png\n", options.outputPrefix.c_str());
}

}  // namespace

int truthCommand(const Options& options) {
  Selection selection = options.selection;
  if (selection.scenes.size() > 1)
    throw InputError("--scene", "found several scenes, expected one");
  selection.techniques = {kReferenceTechnique};
  if (selection.scenes.empty()) selection.scenes = {"layers"};
  const CellId id = selectCells(selection, {}, {}).front();
  for (const char* extension : {".png", ".exr"})
    requireWritable("--output", options.outputPrefix + extension);
  const Scene scene = makeScene(id.scene);
  for (const std::string& w : scene.warnings) std::fprintf(stderr, "bench: %s\n", w.c_str());
  if (const auto missing = notYetRepresented(scene); !missing.empty()) {
    std::fprintf(stderr, "bench: the truth cannot show this scene yet: %s\n",
                 missing.front().c_str());
    return 1;
  }
  const std::string key = truthKey(sceneHash(scene), id.width, id.height);
  std::optional<Truth> truth;
  if (options.cache) truth = readTruth(truthCacheFolder(), key);
  const bool cached = truth.has_value();
  if (!cached) {
    std::signal(SIGINT, [](int) { g_interrupted = true; });
    Progress progress(!options.quiet);
    truth = Tracer(scene, id.width, id.height)
                .trace({.width = id.width,
                        .height = id.height,
                        .interrupted = &g_interrupted,
                        .progress = [&](double done) { progress.update(id.scene, "trace", done); }});
    if (!truth) return 130;
    if (options.cache) writeTruth(truthCacheFolder(), key, *truth);
  }
  writeAll(options, scene, *truth);
  std::printf("%llu rays in %.2f s: %.2f million a second%s\n",
              static_cast<unsigned long long>(truth->rays), truth->seconds,
              double(truth->rays) / truth->seconds * 1e-6,
              cached ? " (traced by an earlier run)" : "");
  return 0;
}

int cacheCommand(const Options& options) {
  const auto folder = truthCacheFolder();
  const CacheUse use = options.clearCache ? clearCache(folder) : cacheUse(folder);
  std::printf("%s: %llu truths, %.1f MiB%s\n", folder.c_str(),
              static_cast<unsigned long long>(use.files), double(use.bytes) / (1 << 20),
              options.clearCache ? ", removed" : "");
  return 0;
}

}  // namespace sb
