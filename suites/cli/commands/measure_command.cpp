// Measuring: groups, hard cases, progress, tables and files. What is found is kept in a journal at
// once; an interrupt stops after the block under way, and what is finished is written.
#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "backends/rhi/memory_limit.h"
#include "reports/console/console.h"
#include "reports/console/console_figures.h"
#include "reports/console/console_stability.h"
#include "reports/console/console_tradeoff.h"
#include "suites/cli/commands/commands.h"
#include "suites/cli/interrupt.h"
#include "suites/cli/memory.h"
#include "suites/cli/options/help.h"
#include "suites/cli/outputs.h"
#include "suites/cli/progress.h"
#include "suites/cli/runs/run_plan.h"
#include "suites/cli/runs/session.h"
#include "suites/cli/runs/stability_runs.h"
#include "suites/cli/say.h"
#include "suites/cli/vector_width.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

/// Opens the devices of all cells. Cells of backends that do not start go, with a warning that says
/// why, unless the backend was asked for by name: then their records say so.
void openBackends(const Options& options, Devices& devices, RunPlan& plan, report::Run& run) {
  std::set<std::string> names, broken;
  for (const CellId& cell : plan.cells) names.insert(cell.backend);
  for (const StabilityJob& job : plan.jobs) names.insert(job.backend);
  names.erase(kTracerBackend);
  for (const std::string& name : names)
    if (!devices.open(name)) {
      broken.insert(name);
      run.warnings.push_back("backend " + name + " does not start: " + devices.why(name));
      say(run.warnings.back());
    }
  if (const std::string why = devices.whyNoSuchDevice(); !why.empty())
    throw InputError("--device", why);
  if (options.selection.backends.empty())
    std::erase_if(plan.cells, [&](const CellId& cell) { return broken.contains(cell.backend); });
}

/// Reads files before anything is measured: an error in the last one should not cost minutes.
void checkScenes(const RunPlan& plan, report::Run& run) {
  std::set<std::string> seen;
  const auto check = [&](const std::string& spec, rhi::Extent2D size, Made made) {
    if (!seen.insert(spec + " " + std::to_string(size.width) + "x" + std::to_string(size.height))
             .second)
      return;
    const Scene scene = makeScene(spec);
    requireMemory(scene, size, made);
    if (!seen.insert(spec).second) return;
    for (const std::string& warning : scene.warnings)
      run.warnings.push_back("scene " + spec + ": " + warning);
  };
  for (const CellId& cell : plan.cells)
    check(cell.scene, {cell.width, cell.height},
          plan.settings.judge.enabled ? Made::Truth : Made::Picture);
  for (const StabilityJob& job : plan.jobs)
    if (!job.scene.empty()) check(job.scene, job.size, Made::Truth);
}

/// What is finished; in the order of the plan when it is told.
struct Results {
  std::map<CellId, report::Record> cells;  ///< by recordedId()
  std::map<std::string, report::StabilityRecord> hardCases;
  size_t count() const { return cells.size() + hardCases.size(); }
  void tell(const RunPlan& plan, report::Run& run) const {
    for (const CellId& id : plan.cells)
      if (auto found = cells.find(recordedId(id)); found != cells.end())
        run.records.push_back(found->second);
    for (const StabilityJob& job : plan.jobs)
      if (auto found = hardCases.find(jobName(job)); found != hardCases.end())
        run.stability.push_back(found->second);
    run.cellsPlanned = plan.size();
    run.cellsDone = run.records.size() + run.stability.size();
    run.interrupted = run.cellsDone < run.cellsPlanned;
  }
};

/// A cell that an earlier part of the run finished, measured again beside others: what it lacks of
/// comparisons comes from there.
void completeRatios(report::Record& kept, const report::Record& again) {
  if (kept.status != report::Status::Ok || again.status != report::Status::Ok) return;
  if (kept.ratios.empty()) kept.ratios = again.ratios;
  if (!kept.ratios.empty()) kept.why.erase("ratios");
}

void measureAll(const Options& options, RunPlan& plan, Devices& devices, Session& session,
                Outputs& outputs, Results& found) {
  Progress progress(!options.quiet);
  const auto groups = groupsLeft(groupCells(plan.cells), session.earlier());
  MeasureSettings settings = plan.settings;
  settings.interrupted = &interrupted();
  settings.judge.interrupted = &interrupted();
  settings.earlierBlocks = &session.earlier().blocks;
  settings.onBlock = [&](const CellId& cell, const SampleBlock& block) {
    session.journal().block(cell, block);
  };
  settings.onVerified = [&](const CellResult& result) {
    outputs.addPictures(result.files);
    session.journal().cell(result.record);
  };
  for (size_t g = 0; g < groups.size() && !interrupted(); ++g) {
    settings.progress = [&](const std::string& what, double done) {
      progress.update(groups[g].front().id.scene, what, (double(g) + done) / double(groups.size()));
    };
    for (CellResult& result : measureGroup(groups[g], devices, settings, SHADOWBENCH_VERSION)) {
      const CellId id = result.record.id;
      if (result.companion) {
        if (auto kept = found.cells.find(id); kept != found.cells.end())
          completeRatios(kept->second, result.record);
        continue;
      }
      outputs.addPictures(result.files);
      session.journal().cell(result.record);
      found.cells.insert_or_assign(id, std::move(result.record));
    }
  }
}

void runHardCases(const Options& options, const RunPlan& plan, Devices& devices, Session& session,
                  Results& found) {
  std::vector<StabilityJob> left;
  for (const StabilityJob& job : plan.jobs)
    if (!found.hardCases.contains(jobName(job))) left.push_back(job);
  Progress progress(!options.quiet);
  runStability(
      left, devices, interrupted(),
      [&](const StabilityJob& job, size_t done) {
        progress.update("hard cases", jobName(job), double(done) / double(left.size()));
      },
      [&](const StabilityJob& job, const report::StabilityRecord& record) {
        session.journal().hardCase(record);
        found.hardCases.insert_or_assign(jobName(job), record);
      });
}

/// Some technique was measured with different knobs on one scene: there is accuracy to choose.
bool isSweep(const report::Run& run) {
  std::set<CellId> seen;
  for (const report::Record& r : run.records) {
    CellId id = r.id;
    id.knobs.clear();
    if (!seen.insert(std::move(id)).second) return true;
  }
  return false;
}

void printTables(const Options& options, const report::Run& run) {
  // With a format of the library's on the console, standard output is the library's alone.
  if (options.benchmark.display) return;
  if (!run.records.empty()) {
    print(report::toTable(run));
    if (isSweep(run)) {
      const std::string table = report::toTable(report::tradeOffs(run));
      print("\n" + (table.empty() ? "No trade-off of time and error: no two cells of one scene have "
                                    "both an error and a time that is not contaminated.\n"
                                  : table));
    }
  }
  print(report::figuresText(run) + report::toTable(run.stability));
}

bool isSkipForMemory(const report::Record& r) {
  return r.status == report::Status::Skipped && r.reason.starts_with(rhi::kTooLargeWords);
}

int exitCode(const Options& options, const report::Run& run) {
  bool anyOk = false, anyFailed = false;
  size_t skips = 0;
  for (const report::StabilityRecord& r : run.stability) {
    anyOk |= r.verdict != report::Verdict::Skipped;
    anyFailed |= r.verdict == report::Verdict::Fail;
  }
  for (const report::Record& r : run.records) {
    anyOk |= r.status == report::Status::Ok;
    anyFailed |= r.status == report::Status::Failed;
    skips += isSkipForMemory(r);
  }
  if (!anyOk) say("no cell could be measured");
  if (skips > 0 && !options.measuring.allowSkips)
    say(std::to_string(skips) + " cells were skipped for want of memory (--allow-skips)");
  return anyFailed || !anyOk || (skips > 0 && !options.measuring.allowSkips) ? 1 : 0;
}

}  // namespace

int measureCommand(const Options& given) {
  const Options options = resolveResume(given);
  limitMemory(options);
  Platform platform = makePlatform(options);
  Devices devices(platform.backends(), platform.shaders,
                  {.selector = options.device.selector, .validate = options.device.validate});
  RunPlan plan = planRun(options, platform.names());
  if (options.list) {
    for (const CellId& cell : plan.cells) print(cellName(cell) + "\n");
    for (const StabilityJob& job : plan.jobs) print(jobName(job) + "\n");
    return 0;
  }
  report::Run run = report::describeMachine("bench", SHADOWBENCH_VERSION);
  describeLibrary(run);
  run.commandLine = commandLine(options.arguments);
  run.figures = plan.figures;
  if (const std::string width = vectorWidth(); !width.empty()) {
    run.warnings.push_back(vectorWidthNote(width));
    say("warning: " + run.warnings.back());
  }
  Outputs outputs(options);
  checkScenes(plan, run);
  openBackends(options, devices, plan, run);
  // Begun when all else has been found right.
  Session session(options, describeRun(options, plan.settings, plan.cells, plan.jobs, devices, run));
  const std::filesystem::path pictures = picturesOf(options, session.journal().path());
  outputs.keepPictures(pictures);
  watchInterrupts();
  note(describePlan(plan, run) + "; journal " + session.journal().path().string());

  Results found{.cells = session.earlier().cells, .hardCases = session.earlier().hardCases};
  if (session.isResumed())
    say("going on: " + std::to_string(found.count()) + " of " + std::to_string(plan.size()) +
        " are finished");
  measureAll(options, plan, devices, session, outputs, found);
  runHardCases(options, plan, devices, session, found);
  found.tell(plan, run);
  if (run.interrupted)
    run.warnings.push_back("interrupted: " + std::to_string(run.cellsDone) + " of " +
                           std::to_string(run.cellsPlanned) + " cells are finished");
  printTables(options, run);
  // An earlier run's results give way to results alone.
  bool written = run.cellsDone == 0 || outputs.write(run);
  if (run.cellsDone > 0)
    written &= outputs.writeText("--benchmark_out", options.benchmark.outFile,
                                 runBenchmarks(options.benchmark, run.records));
  if (!session.journal().failure().empty())
    say("warning: the journal could not be written: " + session.journal().failure());
  const bool arrived = printed();
  if (!arrived) say("standard output: writing failed");
  if (run.interrupted && interrupted()) {
    say("interrupted; " + std::to_string(run.cellsDone) + " of " +
        std::to_string(run.cellsPlanned) + " cells are finished; to go on: bench --resume " +
        session.journal().path().string());
    return interruptExitCode();
  }
  if (written && arrived) session.finish(pictures);
  const int code = exitCode(options, run);
  return written && arrived ? code : std::max(code, 1);
}

}  // namespace sb
