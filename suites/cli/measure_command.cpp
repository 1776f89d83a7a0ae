// Measuring: selection, groups, progress, tables and files. Ctrl-C stops after the frame under way;
// what is finished is written.
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <set>

#include "reports/console.h"
#include "reports/console_figures.h"
#include "reports/console_stability.h"
#include "reports/console_tradeoff.h"
#include "suites/cli/commands.h"
#include "suites/cli/outputs.h"
#include "suites/cli/progress.h"
#include "suites/cli/stability_runs.h"
#include "suites/harness/group.h"
#include "suites/harness/suite.h"
#include "suites/scenes/procedural.h"
#include "suites/truth/truth_cache.h"
#include "techniques/common/error.h"

namespace sb {
namespace {

std::atomic<bool> g_interrupted = false;
volatile std::sig_atomic_t g_signal = 0;

void onInterrupt(int signal) {
  // A second Ctrl-C ends the program at once.
  if (g_interrupted.exchange(true)) _exit(128 + signal);
  g_signal = signal;
}

bool isQuick(const Options& options) {
  const Selection& s = options.selection;
  return options.suite.empty() && s.techniques.empty() && s.backends.empty() && s.scenes.empty() &&
         s.sets.empty() && s.edits.empty() && s.filter.empty() && !s.size;
}

/// Opens the devices of all cells. Cells of backends that do not start go, with a warning that says
/// why, unless the backend was asked for by name: then their records say so.
void openBackends(const Options& options, Devices& devices, std::vector<CellId>& cells,
                  report::Run& run) {
  std::set<std::string> names, broken;
  for (const CellId& cell : cells) names.insert(cell.backend);
  names.erase(kReferenceBackend);
  for (const std::string& name : names)
    if (!devices.open(name)) {
      broken.insert(name);
      run.warnings.push_back("backend " + name + " does not start: " + devices.why(name));
      std::fprintf(stderr, "bench: %s\n", run.warnings.back().c_str());
    }
  if (const std::string why = devices.whyNoSuchDevice(); !why.empty())
    throw InputError("--device", why);
  if (options.selection.backends.empty())
    std::erase_if(cells, [&](const CellId& cell) { return broken.contains(cell.backend); });
}

/// Reads files before anything is measured: an error in the last one should not cost minutes.
void checkScenes(const std::vector<CellId>& cells, report::Run& run) {
  std::set<std::string> seen;
  for (const CellId& cell : cells) {
    if (!seen.insert(cell.scene).second) continue;
    for (const std::string& warning : makeScene(cell.scene).warnings)
      run.warnings.push_back("scene " + cell.scene + ": " + warning);
  }
}

MeasureSettings settingsOf(const Options& options, bool quick) {
  MeasureSettings s;
  s.budgetSeconds = options.budgetSeconds.value_or(quick ? 0.7 : 3);
  s.budgetSeconds = std::max(s.budgetSeconds, options.benchmark.minSeconds);
  s.stop.precision = options.precisionPercent.value_or(5) / 100;
  // A minimum of time is a wish for more than precision alone would give.
  if (options.benchmark.minSeconds > 0) s.stop.precision = 0;
  s.stop.repetitions = options.benchmark.repetitions;
  s.interrupted = &g_interrupted;
  s.judge.enabled = options.truth;
  s.judge.seeds = options.seeds.value_or(quick ? 8 : s.judge.seeds);
  if (options.cache) s.judge.cache = truthCacheFolder();
  s.judge.interrupted = &g_interrupted;
  return s;
}

/// Measures group by group and writes the files after each.
void measureAll(const Options& options, const std::vector<CellId>& cells, Devices& devices,
                bool quick, Outputs& outputs, report::Run& run) {
  Progress progress(!options.quiet);
  const auto groups = groupCells(cells);
  for (size_t g = 0; g < groups.size() && !g_interrupted; ++g) {
    MeasureSettings settings = settingsOf(options, quick);
    settings.progress = [&](const std::string& what, double done) {
      progress.update(groups[g].front().scene, what, (double(g) + done) / double(groups.size()));
    };
    for (CellResult& result : measureGroup(groups[g], devices, settings, SHADOWBENCH_VERSION)) {
      if (result.id.companion) continue;
      run.records.push_back(std::move(result.record));
      outputs.addPictures(result.files);
    }
    outputs.write(run, false);
  }
}

/// Some technique was measured with different knobs on one scene: there is accuracy to choose.
bool isSweep(const report::Run& run) {
  std::set<std::string> seen;
  for (const report::Record& r : run.records)
    if (!seen.insert(r.technique + "/" + r.transparency + "/" + r.backend + "/" + r.scene).second)
      return true;
  return false;
}

/// `asked`: cells and hard cases.
int exitCode(const report::Run& run, size_t asked) {
  if (g_interrupted) {
    std::fprintf(stderr, "bench: interrupted; %zu of %zu cells are finished\n",
                 run.records.size() + run.stability.size(), asked);
    return 128 + g_signal;
  }
  bool anyOk = false, anyFailed = false;
  for (const report::StabilityRecord& r : run.stability) {
    anyOk |= r.verdict != report::Verdict::Skipped;
    anyFailed |= r.verdict == report::Verdict::Fail;
  }
  for (const report::Record& r : run.records) {
    anyOk |= r.status == report::Status::Ok;
    anyFailed |= r.status == report::Status::Failed;
  }
  if (!anyOk) std::fprintf(stderr, "bench: no cell could be measured\n");
  return anyFailed || !anyOk ? 1 : 0;
}

}  // namespace

int measureCommand(const Options& given) {
  Options options = given;
  Platform platform = makePlatform(options);
  Devices devices(platform.backends(), platform.shaders,
                  {.selector = options.device, .validate = options.validate});
  report::Run run = report::describeMachine("bench", SHADOWBENCH_VERSION);
  describeLibrary(run);
  Selection selection = options.selection;
  const bool quick = isQuick(options);
  if (quick) selection.size = {256, 256};

  std::vector<CellId> cells;
  std::vector<StabilityJob> jobs;
  if (options.suite.empty()) {
    cells = selectCells(selection, platform.names(), defaultBackends(options));
  } else {
    const Suite suite = loadSuite(options.suite);
    cells = suiteCells(suite, selection, platform.names(), defaultBackends(options));
    run.figures = suiteFigures(suite, selection, platform.names(), defaultBackends(options));
    jobs = stabilityJobs(suite, selection, defaultBackends(options));
    if (cells.empty() && jobs.empty())
      throw InputError("--filter", "'" + selection.filter + "' matches nothing of the suite");
    if (!options.seeds) options.seeds = suite.seeds;
    if (!options.budgetSeconds) options.budgetSeconds = suite.budgetSeconds;
    if (!options.precisionPercent) options.precisionPercent = suite.precisionPercent;
  }
  if (options.list) {
    for (const CellId& cell : cells) std::printf("%s\n", cellName(cell).c_str());
    for (const StabilityJob& job : jobs) std::printf("%s\n", jobName(job).c_str());
    return 0;
  }
  Outputs outputs(options);
  checkScenes(cells, run);
  openBackends(options, devices, cells, run);
  const size_t asked = cells.size() + jobs.size();

  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  measureAll(options, cells, devices, quick, outputs, run);
  Progress progress(!options.quiet);
  runStability(jobs, devices, run, g_interrupted, [&](const StabilityJob& job, size_t done) {
    progress.update("hard cases", jobName(job), double(done) / double(jobs.size()));
  });
  outputs.write(run, true);
  // With a format of the library's on the console, standard output is the library's alone.
  if (!options.benchmark.display && !run.records.empty()) {
    std::printf("%s", report::toTable(run).c_str());
    if (isSweep(run)) std::printf("\n%s", report::toTable(report::tradeOffs(run)).c_str());
  }
  if (!options.benchmark.display)
    std::printf("%s%s", report::figuresText(run).c_str(), report::toTable(run.stability).c_str());
  runBenchmarks(options.benchmark, run.records);
  return exitCode(run, asked);
}

}  // namespace sb
