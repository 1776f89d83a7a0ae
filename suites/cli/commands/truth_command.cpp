// bench truth: the ray-traced reference of a scene as pictures. bench cache: the truths on disk
// and the runs that ended early.
#include <fmt/format.h>

#include <filesystem>
#include <iterator>

#include "reports/picture.h"
#include "suites/cli/commands/commands.h"
#include "suites/cli/interrupt.h"
#include "suites/cli/memory.h"
#include "suites/cli/output_files.h"
#include "suites/cli/progress.h"
#include "suites/cli/runs/unfinished_runs.h"
#include "suites/cli/say.h"
#include "suites/cli/visibility_files.h"
#include "suites/harness/scene_hash.h"
#include "suites/harness/suite/selection.h"
#include "suites/metrics/exposure.h"
#include "suites/scenes/procedural/procedural.h"
#include "suites/truth/tracer.h"
#include "suites/truth/truth_cache.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

void writeAll(const Options& options, const Scene& scene, const Truth& truth) {
  const std::string& prefix = options.picture.prefix;
  const report::Picture image{truth.width, truth.height, truth.image};
  report::writePng(prefix + ".png", image, options.exposure.value_or(automaticExposure(image)));
  report::writeExr(prefix + ".exr", image);
  print(prefix + ".png " + prefix + ".exr\n");
  VisibilityLayers layers;
  for (uint32_t light = 0; light < scene.lights.size(); ++light)
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer)
      layers[{light, layer}] = &truth.visibility[light * kTruthLayers + layer];
  for (uint32_t light = 0; light < truth.mediaVisibility.size(); ++light)
    layers[{light, kWithinMedia}] = &truth.mediaVisibility[light];
  if (!layers.empty()) writeVisibility(prefix, {truth.width, truth.height}, std::move(layers));
  std::vector<float> edges;
  for (const uint8_t e : truth.imageEdges)
    edges.insert(edges.end(), {float(e), float(e), float(e), 1});
  report::writePng(prefix + ".edges.png", {truth.width, truth.height, std::move(edges)});
  print(prefix + ".edges.png\n");
}

}  // namespace

int truthCommand(const Options& options) {
  Selection selection = options.selection;
  if (selection.scenes.size() > 1)
    throw InputError("--scene", "found several scenes, expected one");
  selection.techniques = {referenceInfo().name};
  if (selection.scenes.empty()) selection.scenes = {"layers"};
  const CellId id = selectCells(selection, {}, {}).front();
  limitMemory(options);
  const Scene scene = makeScene(id.scene);
  requireOutputs(options, scene);
  requireMemory(scene, {id.width, id.height}, Made::TruthFiles);
  for (const std::string& w : scene.warnings) say(w);
  const std::string key = truthKey(sceneHash(scene), id.width, id.height);
  std::optional<Truth> truth;
  if (options.cache.used) truth = readTruth(truthCacheFolder(), key);
  const bool cached = truth.has_value();
  if (!cached) {
    watchInterrupts();
    Progress progress(!options.quiet);
    truth =
        Tracer(scene, id.width, id.height)
            .trace({.width = id.width,
                    .height = id.height,
                    .interrupted = &interrupted(),
                    .progress = [&](double done) { progress.update(id.scene, "trace", done); }});
    if (!truth) return interruptExitCode();
    if (options.cache.used) writeTruth(truthCacheFolder(), key, *truth);
  }
  writeAll(options, scene, *truth);
  print(fmt::format("{} rays in {:.2f} s: {:.2f} million a second{}\n", truth->rays, truth->seconds,
                    double(truth->rays) / truth->seconds * 1e-6,
                    cached ? " (traced by an earlier run)" : ""));
  if (truth->standardError > 0)
    print(fmt::format("standard error of visibility: {:.1e} at most\n", truth->standardError));
  return 0;
}

int cacheCommand(const Options& options) {
  const auto folder = truthCacheFolder();
  const CacheUse use = options.cache.clear ? clearCache(folder) : cacheUse(folder);
  print(fmt::format("{}: {} truths, {:.1f} MiB{}\n", folder.string(), use.files,
                    double(use.bytes) / (1 << 20), options.cache.clear ? ", removed" : ""));
  const UnfinishedRuns runs = options.cache.clear ? clearUnfinishedRuns() : unfinishedRuns();
  const std::string where = unfinishedRunsFolder().string();
  if (runs.ended > 0)
    print(fmt::format("{}: {} runs that ended early{}\n", where, runs.ended,
                      options.cache.clear ? ", removed" : " (bench --resume FOLDER/run.journal)"));
  if (runs.underWay > 0) print(fmt::format("{}: {} runs under way\n", where, runs.underWay));
  return 0;
}

}  // namespace sb
