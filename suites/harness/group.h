// Measures a group of cells that are compared with each other, interleaved in one process (design,
// section 6): prepare, warm up, take the untimed picture, then blocks of plain frames in ABBA order
// until every cell is precise enough or the budget is spent, then stamped frames, then the picture
// again and the comparison across backends.
#pragma once

#include <atomic>
#include <functional>

#include "suites/harness/devices.h"
#include "suites/harness/judge.h"
#include "suites/harness/measuring/protocol.h"
#include "suites/harness/measuring/samples.h"
#include "suites/harness/suite/selection.h"

namespace sb {

struct CellResult {
  CellId id;
  bool companion = false;  ///< see GroupCell
  report::Record record;
  report::Picture picture;  ///< of the last timed frame; empty unless the record is ok
  PictureFiles files;       ///< of Record::pictures
  bool finished = false;    ///< measured and verified, or it cannot be
};

struct MeasureSettings {
  double budgetSeconds = 3;  ///< per cell, for plain frames
  StopRule stop;
  double blockSeconds = 0.05;  ///< frames of a block last about so long
  uint32_t stampedFrames = 5;
  /// Devices whose timers fail their check give no times. Off: tests on devices without time.
  bool checkTimers = true;
  JudgeSettings judge;
  /// Polled between blocks: true stops; cells that are not finished are left out.
  const std::atomic<bool>* interrupted = nullptr;
  /// "prepare", "warm up", "measure"...: what is being done, and how much of the group is done,
  /// 0..1.
  std::function<void(const std::string& what, double done)> progress;

  /// Blocks of an earlier part of the run, by recordedId().
  const std::map<CellId, std::vector<SampleBlock>>* earlierBlocks = nullptr;
  /// With the cell's recordedId().
  std::function<void(const CellId& cell, const SampleBlock& block)> onBlock;
  /// A cell is verified, and no companion. What it is compared with is not known yet: its record
  /// says so.
  std::function<void(const CellResult&)> onVerified;
};

/// Results of the cells that are finished, companions included: all of them unless interrupted. A
/// cell that cannot run is a skipped or failed record with its reason. Cells that do not fit the
/// memory beside the others are measured after them, beside their baselines alone, and say so.
/// Throws InputError when the scene cannot be loaded.
std::vector<CellResult> measureGroup(const std::vector<GroupCell>& cells, Devices& devices,
                                     const MeasureSettings& settings, const std::string& version);

}  // namespace sb
