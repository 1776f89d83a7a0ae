#include "suites/cli/runs/stability_runs.h"

#include <new>
#include <optional>
#include <set>

#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"

namespace sb {

std::vector<StabilityJob> stabilityJobs(const Suite& suite, const Selection& over,
                                        const std::vector<std::string>& defaultBackends) {
  const auto& backends = over.backends.empty() ? defaultBackends : over.backends;
  std::vector<StabilityJob> jobs;
  std::set<std::string> names;
  const std::vector<std::string> scenes = namedScenes(over);
  std::optional<rhi::Extent2D> size;
  if (over.size) size = {over.size->first, over.size->second};
  for (const StabilityRun& run : suite.stability) {
    try {
      const auto& techniques = over.techniques.empty() ? run.techniques : over.techniques;
      for (StabilityJob& job : stabilityJobs({.techniques = techniques,
                                              .cases = run.cases,
                                              .backends = backends,
                                              .filter = over.filter,
                                              .variants = run.variants,
                                              .seeds = run.seeds,
                                              .scenes = scenes,
                                              .size = size,
                                              .quick = run.quick}))
        if (names.insert(jobName(job)).second) jobs.push_back(std::move(job));
    } catch (const InputError& e) {
      throw InputError(run.where, e.what());
    }
  }
  return jobs;
}

namespace {

/// The scene of jobs that follow each other, read once.
struct LastScene {
  std::string spec;
  Scene scene;
  const Scene* of(const StabilityJob& job) {
    if (job.scene.empty()) return nullptr;
    if (spec != job.scene) scene = makeScene(job.scene), spec = job.scene;
    return &scene;
  }
};

report::StabilityRecord runOne(const StabilityJob& job, Devices& devices, LastScene& last) {
  DeviceSession* session = devices.open(job.backend);
  if (!session)
    return skippedStability(job, "the backend does not start: " + devices.why(job.backend));
  if (const std::string lost = devices.whyLost(job.backend); !lost.empty())
    return failedStability(job, lost);
  // The other API, not the other way to the same one.
  const std::string other = job.backend == "vulkan" ? "opengl" : "vulkan";
  DeviceSession* second = devices.whyLost(other).empty() ? devices.open(other) : nullptr;
  const DeviceContext device = session->context();
  std::optional<DeviceContext> otherDevice;
  if (second) otherDevice.emplace(second->context());
  try {
    return runStability(job, device, otherDevice ? &*otherDevice : nullptr,
                        last.of(job));
  } catch (const rhi::Error& e) {
    if (rhi::isDeviceLost(e)) devices.lose(job.backend, e.what());
    return failedStability(job, e.what());
  } catch (const std::bad_alloc&) {
    return failedStability(job, "the machine's memory does not hold it");
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& e) {
    return failedStability(job, e.what());
  }
}

}  // namespace

void runStability(
    const std::vector<StabilityJob>& jobs, Devices& devices, const std::atomic<bool>& interrupted,
    const std::function<void(const StabilityJob&, size_t)>& progress,
    const std::function<void(const StabilityJob&, const report::StabilityRecord&)>& finished) {
  LastScene last;
  for (size_t i = 0; i < jobs.size() && !interrupted; ++i) {
    progress(jobs[i], i);
    finished(jobs[i], runOne(jobs[i], devices, last));
  }
}

}  // namespace sb
