// A suite: cells to measure, named by data instead of by arguments (suites/*.toml). Format:
//   title = "..."                    what the suite is about
//   seeds = 64                       optional; as are budget (seconds a cell), precision (percent)
//   [[run]]                          at least one
//   scenes = ["layers", ...]         as on the command line
//   techniques = ["CSSM2", ...]      optional: TECHNIQUE[+TRANSPARENCY][@LIGHTS]; without it all
//   backends = ["vulkan", ...]       optional
//   size = "512x512"                 optional
//   set.kernel = 3                   optional: the same for all cells
//   grid.size = [512, 1024]          optional: every combination of these
//   sweep.kernel = [1, 3, 9]         optional: one knob at a time, the others at their defaults
//   camera = "eye=X,Y,Z,at=X,Y,Z"    optional; as are sun = "direction=X,Y,Z", motion = "..." and
//   materials = ["GLOB:alpha=A"]     changes of the scenes (suites/scenes/edit/scene_edit.h)
// A knob that a technique does not have is left out for it. Beside runs, or without any:
//   [[stability]]                    hard cases (suites/stability)
//   cases = ["G1", ...]              optional: ids; without it all
//   techniques = ["CSSM2", ...]      optional: without it all
//   sweep.format = ["rgba16", ...]   optional: variants, one knob at a time
//   set.kernel = 3                   optional: the same for all of them
//   seeds = 64                       optional: means of stochastic techniques over so many
//   quick = true                     optional: fewer and smaller points of every case
// and [[figure]]: figures of a document that the cells show again (suites/harness/suite/suite_figures.h)
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.h"
#include "suites/harness/suite/selection.h"
#include "suites/harness/suite/suite_figures.h"

namespace sb {

/// What numbers of a suite and of the command line must be.
inline constexpr base::NumberRule kSeedCount{.low = 1, .high = 65536, .whole = true};
inline constexpr base::NumberRule kBudgetSeconds{.low = 0, .high = 1e6, .above = true};
inline constexpr base::NumberRule kPrecisionPercent{.low = 0, .high = 1e6, .above = true};
/// Where neither the command line nor a suite says it; seeds: kDefaultSeeds.
inline constexpr double kDefaultBudgetSeconds = 3;
inline constexpr double kDefaultPrecisionPercent = 5;
/// Longest file of a suite.
inline constexpr uint64_t kSuiteBytes = uint64_t(4) << 20;

struct SuiteRun {
  std::string where;                  ///< "FILE:line: run N", for errors
  std::vector<Selection> selections;  ///< whose cells together are the run's
};

/// Hard cases to ask of techniques; empty lists: all.
struct StabilityRun {
  std::string where;  ///< as in SuiteRun
  std::vector<std::string> cases, techniques;
  std::vector<std::map<std::string, std::string>> variants = {{}};  ///< knobs of each
  uint32_t seeds = 1;
  bool quick = false;  ///< fewer and smaller points of every case
};

struct Suite {
  std::string name;
  std::string title;
  std::optional<uint32_t> seeds;
  std::optional<double> budgetSeconds;
  std::optional<double> precisionPercent;
  std::vector<SuiteRun> runs;
  std::vector<StabilityRun> stability;
  std::vector<SuiteFigure> figures;
};

/// Names of the suites that the program brings.
std::vector<std::string> builtinSuites();

/// A built-in suite by name, or a file whose name ends in .toml. Throws InputError with file, line
/// and field.
Suite loadSuite(const std::string& nameOrFile);
Suite parseSuite(std::string_view text, const std::string& file);

/// Cells of all runs, each once, in order. Backends, size, seed and filter of `over` replace the
/// suite's. Throws InputError like selectCells, with file and line.
std::vector<CellId> suiteCells(const Suite& suite, const Selection& over,
                               const std::vector<std::string>& knownBackends,
                               const std::vector<std::string>& defaultBackends);

}  // namespace sb
