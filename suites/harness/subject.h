// What a group measures: a cell made ready to draw, whatever draws it. A technique on a device of a
// backend, or the tracer on the CPU.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reports/picture.h"
#include "reports/record.h"
#include "suites/harness/cell.h"
#include "suites/harness/devices.h"
#include "suites/harness/stage.h"

namespace sb {

class Subject {
 public:
  virtual ~Subject() = default;
  virtual FrameResult frame(FrameMode mode) = 0;
  /// Frames of a loop of the camera's path, the last of which the truth shows; 1: it stands. Only
  /// whole loops are compared with each other.
  virtual uint32_t steps() const { return 1; }
  /// The last frame's.
  virtual report::Picture picture() = 0;
  /// Compared by CPU time, not by GPU time.
  virtual bool software() const = 0;
  /// Milliseconds that making its pipelines or trees took.
  virtual double createMs() const = 0;
  /// Frames carry passes that can be stamped and counted.
  virtual bool hasPasses() const { return true; }
  /// Pipelines that exist: more of them after a timed frame than before disturb it.
  virtual size_t pipelines() const { return 0; }
  /// What validation said since the last call.
  virtual std::vector<rhi::Message> takeMessages() { return {}; }
  /// Why stamps of passes are not believed, or "".
  virtual std::string passesUntrusted() const { return ""; }
  /// What the last frame left out, for people.
  virtual std::vector<std::string> warnings() { return {}; }

  /// What the last frame came to, by name.
  virtual std::vector<std::pair<std::string, uint64_t>> counts() { return {}; }

  // What the truth is asked too: where its camera stands, after everything that is timed.

  /// Lights that it answers for, as indices into Scene::lights.
  virtual std::vector<uint32_t> lights() const = 0;
  /// Which share of a light's RGB radiance arrives, at each of the truth's layers.
  virtual std::vector<VisibilityImage> visibility(uint32_t light, uint32_t seed) = 0;
  /// How far lookups for a light go around a receiver.
  virtual LookupReach reach(uint32_t) const { return {}; }
  /// Why visibility does not depend on the seed, or "".
  virtual std::string whyNotRandom() const { return "nothing random runs"; }
  /// Fills what the record says of plan and memory.
  virtual void describe(report::Record& record) const = 0;
};

/// What the cells of a group share. Must outlive its subjects.
struct SubjectContext {
  Devices& devices;
  Stage& stage;
  bool checkTimers = true;
};

/// Makes a cell ready. Null when it cannot run: then the record is skipped or failed, with the
/// reason. Fills the record's device keys. Throws rhi::Error when the device refuses.
std::unique_ptr<Subject> makeSubject(const CellId& id, SubjectContext& context,
                                     report::Record& record);

}  // namespace sb
