#include "suites/cli/runs/run_plan.h"

#include <algorithm>
#include <set>

#include "base/number.h"
#include "base/text.h"
#include "suites/cli/commands/commands.h"
#include "suites/cli/runs/stability_runs.h"
#include "suites/truth/truth_cache.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

/// Without cells named one by one, the suite `quick`.
std::string suiteOf(const Options& options) {
  const Selection& s = options.selection;
  if (!options.measuring.suite.empty()) return options.measuring.suite;
  const bool named =
      !(s.techniques.empty() && s.scenes.empty() && s.sets.empty() && s.edits.empty());
  return named ? "" : "quick";
}

/// A suite names its cells itself. Hard cases alone may be asked of other techniques and scenes.
void requireFitting(const Selection& s, const Suite& suite) {
  if (!s.sets.empty() ||
      (!suite.runs.empty() && !(s.techniques.empty() && s.scenes.empty() && s.edits.empty())))
    throw InputError("--suite", "found it beside --technique, --scene, --set or changes of a scene: "
                                "a suite names these itself");
  if (s.scenes.empty() && !s.edits.empty())
    throw InputError("--suite", "found it beside changes of a scene, expected --scene too");
  if (suite.runs.empty() && s.scenes.empty() && s.size)
    throw InputError("--size", "found it for hard cases with pictures of their own, expected --scene too");
}

MeasureSettings settingsOf(const Options& options, const Suite& suite) {
  MeasureSettings s;
  s.budgetSeconds =
      options.measuring.budgetSeconds.value_or(suite.budgetSeconds.value_or(kDefaultBudgetSeconds));
  s.budgetSeconds = std::max(s.budgetSeconds, options.benchmark.minSeconds);
  s.stop.precision = options.measuring.precisionPercent.value_or(
                         suite.precisionPercent.value_or(kDefaultPrecisionPercent)) /
                     100;
  // A minimum of time is a wish for more than precision alone would give.
  if (options.benchmark.minSeconds > 0) s.stop.precision = 0;
  s.stop.repetitions = options.benchmark.repetitions;
  s.judge.enabled = options.measuring.truth;
  s.judge.seeds = options.measuring.seeds.value_or(suite.seeds.value_or(kDefaultSeeds));
  s.judge.exposure = options.exposure;
  if (options.cache.used) s.judge.cache = truthCacheFolder();
  return s;
}

}  // namespace

RunPlan planRun(const Options& options, const std::vector<std::string>& known) {
  const std::vector<std::string> defaults = defaultBackends(options);
  RunPlan plan{.suite = suiteOf(options)};
  Suite suite;
  if (plan.suite.empty()) {
    plan.cells = selectCells(options.selection, known, defaults);
  } else {
    suite = loadSuite(plan.suite);
    requireFitting(options.selection, suite);
    // Cells and hard cases are filtered together: a name may be of either.
    Selection all = options.selection;
    all.filter.clear();
    const auto cells = suiteCells(suite, all, known, defaults);
    if (options.measuring.seeds)
      for (StabilityRun& run : suite.stability) run.seeds = *options.measuring.seeds;
    const auto jobs = stabilityJobs(suite, all, defaults);
    std::vector<std::string> names;
    for (const CellId& id : cells) names.push_back(cellName(id));
    for (const StabilityJob& job : jobs) names.push_back(jobName(job));
    const NameFilter filter(options.selection, names);
    std::ranges::copy_if(cells, std::back_inserter(plan.cells),
                         [&](const CellId& id) { return filter.keeps(cellName(id)); });
    std::ranges::copy_if(jobs, std::back_inserter(plan.jobs),
                         [&](const StabilityJob& job) { return filter.keeps(jobName(job)); });
    plan.figures = suiteFigures(suite, options.selection, known, defaults);
  }
  plan.settings = settingsOf(options, suite);
  return plan;
}

std::string describePlan(const RunPlan& plan, const report::Run& run) {
  std::set<std::string> sizes, backends;
  for (const CellId& id : plan.cells) {
    sizes.insert(std::to_string(id.width) + "x" + std::to_string(id.height));
    backends.insert(id.backend);
  }
  for (const StabilityJob& job : plan.jobs) {
    backends.insert(job.backend);
    if (!job.scene.empty())
      sizes.insert(std::to_string(job.size.width) + "x" + std::to_string(job.size.height));
  }
  const auto listed = [](const std::set<std::string>& words) {
    std::string out;
    for (const std::string& w : words) out += (out.empty() ? "" : ", ") + w;
    return out;
  };
  const MeasureSettings& s = plan.settings;
  std::string text;
  if (!plan.cells.empty()) text = base::counted(plan.cells.size(), "cell");
  if (!plan.jobs.empty())
    text += (text.empty() ? "" : " and ") + base::counted(plan.jobs.size(), "hard case");
  if (!plan.suite.empty()) text += " of the suite " + plan.suite;
  text += " on " + listed(backends);
  if (!sizes.empty()) text += ", size " + listed(sizes);
  if (s.stop.repetitions > 0)
    text += ", " + std::to_string(s.stop.repetitions) + " repetitions";
  else
    text += ", budget " + base::numberText(s.budgetSeconds) + " s a cell, precision " +
            base::numberText(100 * s.stop.precision) + " %";
  text += s.judge.enabled ? ", " + base::counted(s.judge.seeds, "seed") : ", no truth";
  return text + "; " + run.buildType + " build " + run.version + " (" + run.commit + ")";
}

}  // namespace sb
