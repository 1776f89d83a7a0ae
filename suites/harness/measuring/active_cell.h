// A cell under measurement: warmed up, drawn in blocks between those of others, and in the end
// stamped and counted.
#pragma once

#include <atomic>
#include <memory>

#include "suites/harness/group.h"

namespace sb {

class ActiveCell {
 public:
  /// Takes the untimed picture after warming up, and goes on with `earlier` blocks, if any.
  ActiveCell(CellResult& result, std::unique_ptr<Subject> subject, const MeasureSettings& settings);

  /// One block; said to MeasureSettings::onBlock.
  void measureBlock();
  /// Whether a further block would take more than the cell's own budget, for a cell so slow that
  /// even the fewest blocks of an interval take several budgets.
  bool isSpent() const;
  bool isSlow() const { return m_slow; }
  bool ok() const { return m_result->record.status == report::Status::Ok; }
  bool software() const { return m_software; }
  double secondsInBlocks() const { return m_seconds; }
  const Samples& samples() const { return m_samples; }
  CellResult& result() { return *m_result; }
  /// Stamped frames, times and counts; the picture of the last timed frame.
  void finish(Stop stop);
  Subject& subject() { return *m_subject; }

 private:
  void warmUp();
  std::vector<FrameResult> frames(FrameMode mode, uint32_t count);
  void takeMessages();
  double blockSeconds() const { return m_frameMs * 1e-3 * double(m_framesPerBlock); }
  bool interrupted() const { return m_settings->interrupted && m_settings->interrupted->load(); }

  CellResult* m_result;
  std::unique_ptr<Subject> m_subject;
  const MeasureSettings* m_settings;
  Samples m_samples;
  std::string m_untimedPicture;  ///< content hash
  uint32_t m_framesPerBlock = 1;
  double m_frameMs = 0;  ///< of a warm frame, wall time
  double m_seconds = 0;  ///< wall time of blocks
  bool m_software;
  bool m_slow = false;
};

/// Adds a text to a list that does not have it.
void addOnce(std::vector<std::string>& list, const std::string& text);

}  // namespace sb
