// Measuring: selection, groups, progress, tables and files. Ctrl-C stops after the frame under way;
// what is finished is written.
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>

#include "reports/atomic_file.h"
#include "reports/console.h"
#include "reports/csv.h"
#include "reports/json.h"
#include "suites/cli/commands.h"
#include "suites/harness/group.h"

namespace sb {
namespace {

std::atomic<bool> g_interrupted = false;

void onInterrupt(int signal) {
  // A second Ctrl-C ends the program at once.
  if (g_interrupted.exchange(true)) _exit(128 + signal);
}

class Progress {
 public:
  explicit Progress(bool show) : m_show(show && isatty(2)) {}
  void update(const std::string& what, double done) {
    if (!m_show) return;
    std::fprintf(stderr, "\r\033[K[%3.0f %%] %s", 100 * done, what.c_str());
    std::fflush(stderr);
  }
  ~Progress() {
    if (m_show) std::fprintf(stderr, "\r\033[K");
  }

 private:
  bool m_show;
};

bool isQuick(const Selection& s) {
  return s.techniques.empty() && s.backends.empty() && s.scenes.empty() && s.sets.empty() &&
         s.filter.empty() && !s.size;
}

/// Backends that start; of the others, why not (unless they were asked for by name: then the cells
/// say so themselves).
std::vector<std::string> workingBackends(const Options& options, Devices& devices,
                                         report::Run& run) {
  std::vector<std::string> working;
  for (const std::string& name : defaultBackends(options)) {
    if (devices.open(name)) working.push_back(name);
    else run.warnings.push_back("backend " + name + " does not start: " + devices.why(name));
  }
  return working;
}

void writeFiles(const Options& options, const report::Run& run) {
  if (!options.jsonFile.empty()) report::writeAtomically(options.jsonFile, report::toJson(run));
  if (!options.csvFile.empty()) report::writeAtomically(options.csvFile, report::toCsv(run));
}

MeasureSettings settingsOf(const Options& options, bool quick) {
  MeasureSettings s;
  s.budgetSeconds = options.budgetSeconds.value_or(quick ? 1 : 3);
  s.budgetSeconds = std::max(s.budgetSeconds, options.benchmark.minSeconds);
  s.precision = options.precisionPercent.value_or(5) / 100;
  // A minimum of time is a wish for more than precision alone would give.
  if (options.benchmark.minSeconds > 0) s.precision = 0;
  s.blocks = options.benchmark.repetitions;
  s.interrupted = &g_interrupted;
  return s;
}

}  // namespace

int measureCommand(const Options& options) {
  Platform platform = makePlatform(options);
  Devices devices(platform.backends(), platform.shaders,
                  {.selector = options.device, .validate = options.validate});
  report::Run run = report::describeMachine("bench", SHADOWBENCH_VERSION);
  Selection selection = options.selection;
  const bool quick = isQuick(selection);
  if (quick) selection.size = {256, 256};

  const std::vector<std::string> defaults =
      !selection.backends.empty() ? selection.backends
      : options.list              ? defaultBackends(options)
                                  : workingBackends(options, devices, run);
  const std::vector<CellId> cells = selectCells(selection, platform.names(), defaults);
  if (options.list) {
    for (const CellId& cell : cells) std::printf("%s\n", cellName(cell).c_str());
    return 0;
  }
  if (run.loadAverage.size() == 3 && run.loadAverage[0] > 0.5 * run.cpus)
    run.warnings.push_back("contaminated: other programs load this machine");

  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
  {
    Progress progress(!options.quiet);
    const auto groups = groupCells(cells);
    for (size_t g = 0; g < groups.size() && !g_interrupted; ++g) {
      MeasureSettings settings = settingsOf(options, quick);
      settings.progress = [&](const std::string& what, double done) {
        progress.update(groups[g].front().scene + ": " + what,
                        (double(g) + done) / double(groups.size()));
      };
      for (CellResult& result : measureGroup(groups[g], devices, settings, SHADOWBENCH_VERSION))
        if (!result.id.companion) run.records.push_back(std::move(result.record));
      writeFiles(options, run);
    }
  }
  std::printf("%s", report::toTable(run).c_str());
  writeFiles(options, run);
  runBenchmarks(options.benchmark, run.records);
  if (g_interrupted) {
    std::fprintf(stderr, "bench: interrupted; %zu of %zu cells are finished\n", run.records.size(),
                 cells.size());
    return 130;
  }
  for (const report::Record& r : run.records)
    if (r.status == report::Status::Failed) return 1;
  return 0;
}

}  // namespace sb
