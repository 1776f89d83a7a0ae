// What a run will measure, and how: from options and suites.
#pragma once

#include "suites/cli/options/options.h"
#include "suites/harness/group.h"
#include "suites/harness/suite/suite.h"
#include "suites/stability/stability.h"

namespace sb {

struct RunPlan {
  std::string suite;  ///< name; "": the cells were named one by one
  std::vector<CellId> cells;
  std::vector<StabilityJob> jobs;
  std::vector<report::Figure> figures;
  MeasureSettings settings;
  size_t size() const { return cells.size() + jobs.size(); }
};

/// Throws InputError for what does not exist or matches nothing.
RunPlan planRun(const Options& options, const std::vector<std::string>& knownBackends);

/// One line: how much, of what size, for how long, on what.
std::string describePlan(const RunPlan& plan, const report::Run& run);

}  // namespace sb
