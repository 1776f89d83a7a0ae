// Raw measurements of one cell, and the record that is made of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/picture.h"
#include "reports/record.h"
#include "suites/harness/cell.h"
#include "techniques/draw/frame/frame.h"

namespace sb {

/// One repetition: consecutive frames between the blocks of other cells.
struct SampleBlock {
  std::vector<FrameResult> frames;
};

/// A loop of stamped frames, and a loop of plain ones right after it: what the stamps of passes are
/// held against.
struct StampedLoop {
  std::vector<FrameResult> stamped, plain;
};

struct Samples {
  /// Frames of a loop of the camera's path: blocks and stamped frames are whole loops. Times are
  /// means over a loop where they are of one frame otherwise, counts those of the last frame.
  uint32_t loop = 1;
  double compileMs = 0;  ///< pipeline creation plus what the first frame took beyond a warm one
  std::vector<SampleBlock> blocks;  ///< plain frames
  std::vector<StampedLoop> stamped;
  /// Plain frames that were left out since their time stamps could not be true. Whole loops.
  uint64_t dropped = 0;
  std::optional<FrameResult> counted;
  std::string passesUntrusted;  ///< why the device's stamps of passes are not believed, or ""
};

/// Adds a block of plain frames, whole loops. Where stamps make the time, loops with broken ones
/// are dropped and counted. False: none was left, and no block was added.
bool addBlock(Samples& samples, std::vector<FrameResult> frames, bool software);
/// Adds a stamped loop and its plain one, unless a stamp of either is broken.
void addStamped(Samples& samples, StampedLoop loop);

/// The time that frames are ranked by, milliseconds: CPU time of all threads on software devices
/// (wall time there has a spread of 9-28 %, facts.md), GPU time otherwise.
double rankingMs(const FrameResult& frame, bool software);
/// The frame's time: wall time to completion on software devices, GPU time otherwise.
double frameMs(const FrameResult& frame, bool software);
/// Mean ranking time of each block.
std::vector<double> blockMeans(const Samples& samples, bool software);

/// Fills the time and count keys of a record: combined = shadow + scene <= stamped frame. Figures
/// whose timer is not trusted stay absent, with the reason. At least one plain frame is needed.
void summarise(const Samples& samples, bool software, report::Record& record);

}  // namespace sb
