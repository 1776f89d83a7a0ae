// One measured cell as plain data: what every report is written from, and all that needs to be kept
// of a run (design, section 7). Times in milliseconds, memory in bytes. Absent values are empty
// optionals; `why` says, by JSON key, why a value that users would look for is absent.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/cell_id.h"
#include "reports/error_record.h"
#include "reports/figure.h"
#include "reports/stability_record.h"

namespace report {

/// Spread of a sampled quantity. Of times: the median is that of the blocks' means, from which
/// intervals, ratios and fronts come as well; all else is over single frames.
struct Distribution {
  double median = 0;
  double q1 = 0;
  double q3 = 0;
  double cv = 0;  ///< standard deviation / mean
  uint32_t n = 0;
  double p95 = 0;  ///< 95th percentile
  double p99 = 0;
};

/// Passes of one label in a frame, summed.
struct PassRecord {
  std::string label;
  uint32_t count = 1;  ///< passes
  double ms = 0;     ///< median over stamped frames
  double share = 0;  ///< of the stamped frame
  double recordMs = 0;  ///< CPU time of the thread that recorded them, in the same frames
  uint64_t draws = 0;
  uint64_t triangles = 0;
  std::optional<uint64_t> fragments;
};

/// This cell's time over another's, pairwise over interleaved blocks.
struct Ratio {
  std::string kind;     ///< "baseline": the same without shadows; "backend": the same elsewhere
  std::string against;  ///< name of the other cell
  std::string of;       ///< which time: "cpu_ms", "frame_ms"
  double value = 1;     ///< median of the ratios
  double low = 1;       ///< 95 % bootstrap interval
  double high = 1;
  uint32_t n = 0;
};

/// One repetition: a block of consecutive frames between blocks of other cells.
struct Block {
  uint32_t frames = 0;
  double frameMs = 0;  ///< mean per frame
  double cpuMs = 0;    ///< mean per frame, process CPU time of all threads
};

enum class Status : uint8_t { Ok, Skipped, Failed };

struct Record {
  // identity
  CellId id;         ///< its scene as base::printable() gives it
  std::string name;  ///< cellName(id)
  Role role = Role::Technique;
  std::string device, deviceType, driver, sceneHash;
  std::map<std::string, std::string> knobs;  ///< all, defaults too
  std::string version;
  // plan
  std::vector<std::string> effectsPlanned;
  std::vector<std::pair<std::string, std::string>> effectsSkipped;  ///< effect, why
  std::vector<std::string> effectsUnrepresented;
  // time
  std::string timeSource;  ///< "gpu-timestamp", "software", or "wall" on a GPU without timestamps
  std::optional<Distribution> frame, wall, cpu, record, device_;
  std::optional<double> submitMs;
  std::optional<double> compileMs;
  std::vector<PassRecord> passes;
  std::optional<double> shadowMs, sceneMs, combinedMs, stampedFrameMs;
  std::vector<Ratio> ratios;
  std::vector<Block> blocks;
  uint64_t droppedFrames = 0;       ///< whose time stamps could not be true, and which count nowhere
  std::string stoppedBy;            ///< "precision", "budget" or "repetitions"
  std::optional<double> precision;  ///< half width of the median's 95 % interval / the median
  // counts
  uint64_t passCount = 0;
  uint64_t drawCount = 0;
  uint64_t triangleCount = 0;
  uint64_t bytes = 0;
  std::map<std::string, uint64_t> bytesByLabel;
  /// What else the technique counts in the last frame: volumes drawn, casters left out.
  std::map<std::string, uint64_t> counts;
  // verified
  std::optional<bool> stable;                 ///< the timed run's picture equals the untimed one
  std::optional<int> crossBackendMax255;      ///< largest difference to another backend, in 1/255
  std::optional<uint64_t> crossBackendOver1;  ///< pixels that differ by more than 1/255
  std::optional<uint64_t> nonfinite;          ///< values of the picture that are not finite
  std::string picture;                        ///< content hash of the picture
  // error against the truth, of the very frame that was verified
  std::optional<VisibilityError> visibility;  ///< over all lights and layers
  std::vector<LayerError> visibilityLayers;
  std::vector<RegionError> visibilityRegions;
  std::optional<ImageError> image;            ///< of pictures times `exposure`
  /// What pictures are multiplied by before they are shown, and compared as shown; one for a scene.
  double exposure = 1;
  std::optional<NoiseRecord> noise;           ///< stochastic techniques only
  std::optional<Certificate> certificate;     ///< stochastic techniques only
  std::optional<Blame> blame;
  std::optional<double> truthStderr;          ///< standard error of the truth; 0: exact
  /// Pictures beside the results, content hashes by role: "image", "truth", "error", "blame".
  std::map<std::string, std::string> pictures;
  // outcome
  Status status = Status::Ok;
  std::string reason;
  std::vector<std::string> warnings;
  /// Why the times are not what an undisturbed run would give; such a cell is in no ratio.
  std::vector<std::string> contamination;
  std::string command;  ///< reproduces this cell
  std::map<std::string, std::string> why;
};

std::string_view statusName(Status status);

/// Makes a failed record of one whose result cannot be believed: its times and ratios go.
void refuse(Record& record, const std::string& reason);

/// A cache of the CPU, in the words of Google Benchmark's context.
struct Cache {
  std::string type;  ///< "Data", "Instruction" or "Unified"
  int level = 0;
  uint64_t bytes = 0;
  uint32_t sharing = 0;  ///< CPUs that share it
};

/// A whole run: where and with what it was made, and its cells.
struct Run {
  std::string date;  ///< ISO 8601
  std::string host;
  std::string executable;
  std::string version;
  std::string buildType;  ///< "release" or "debug"
  std::string commit;     ///< of the source, "-dirty" behind it when that was changed
  std::string compiler;
  std::string os;
  std::string cpuModel;
  std::string commandLine;
  bool interrupted = false;    ///< not all that was planned is here
  uint64_t cellsPlanned = 0;   ///< and hard cases
  uint64_t cellsDone = 0;
  uint32_t cpus = 0;
  double cpuMHz = 0;
  bool cpuScaling = false;  ///< the governor may change the clock
  std::vector<Cache> caches;
  std::string libraryVersion;  ///< of Google Benchmark
  std::vector<double> loadAverage;
  std::vector<std::string> warnings;  ///< of the run as a whole
  std::vector<Record> records;
  std::vector<StabilityRecord> stability;  ///< hard cases
  std::vector<Figure> figures;             ///< what the suite shows again of a document
};

/// Fills everything but `records` and `warnings` from this machine.
Run describeMachine(const std::string& executable, const std::string& version);

}  // namespace report
