// One frame as a list of named passes. Every pass is counted; in stamped frames each is timed, in
// counted frames its fragments are counted too. Plain frames carry no inner stamps: they perturb
// (facts.md), so a frame's total comes from plain frames and the breakdown from stamped ones.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "backends/rhi/device.h"

namespace sb {

enum class FrameMode : uint8_t { Plain, Stamped, Counted };

/// Which half of the work a pass belongs to (record keys shadow_ms and scene_ms).
enum class PassGroup : uint8_t { Shadow, Scene };

struct PassResult {
  std::string label;
  PassGroup group = PassGroup::Scene;
  rhi::Counters counters;             ///< of this pass alone
  std::optional<double> ms;           ///< stamped frames
  double recordMs = 0;  ///< stamped frames: CPU time of this thread, what is told apart within not
  std::optional<uint64_t> fragments;  ///< counted frames: fragment shader invocations
};

/// What a frame took and did. Times in milliseconds.
struct FrameResult {
  double recordMs = 0;  ///< CPU time of this thread from beginFrame to the end of recording
  double submitMs = 0;  ///< CPU wall time of endFrame
  double callsMs = 0;   ///< CPU time of this thread from beginFrame until endFrame returns
  double wallMs = 0;    ///< from the first command to completion
  double cpuMs = 0;     ///< process CPU time of all threads over the same span
  std::optional<double>
      deviceMs;  ///< between stamps around the whole frame, where they cost nothing
  std::optional<double> stampedMs;  ///< stamped frames: between the first and the last stamp
  /// Why the stamps cannot be true, or "": they then span more than the wall time that held them,
  /// as they do when the device's counter was reset within the frame. Their times stay empty.
  std::string stampsBroken;
  rhi::Counters counters;
  std::vector<PassResult> passes;
};

/// Query pools of a device for stamped and counted frames; shared by all cells of a device. They
/// grow with the longest frame.
class FrameQueries {
 public:
  explicit FrameQueries(rhi::Device& device);
  /// Between frames.
  void grow(rhi::Device& device, uint32_t passes);
  uint32_t capacity() const { return m_capacity; }  ///< passes of a frame
  rhi::QueryPoolId stamps() const { return m_stamps; }
  rhi::QueryPoolId statistics() const { return m_statistics; }
  bool hasStatistics() const { return bool(m_statistics); }
  /// Not every device has timestamps: frames are then measured by wall time alone.
  bool hasStamps() const { return bool(m_stamps); }

 private:
  uint32_t m_capacity = 0;
  rhi::QueryPool m_stamps, m_statistics;
};

class Frame {
 public:
  Frame(rhi::CommandList& commands, FrameQueries& queries, FrameMode mode);

  /// Records a pass: `body` draws. Writes and copies between passes go to commands() and count as
  /// time of the next pass.
  void pass(const rhi::PassDesc& desc, PassGroup group,
            const std::function<void(rhi::CommandList&)>& body);
  /// Work between passes that is measured under a name of its own: CPU work of recording, writes.
  /// Neither counted as a pass nor for fragments.
  void between(const std::string& label, PassGroup group,
               const std::function<void(rhi::CommandList&)>& body);
  rhi::CommandList& commands() { return m_commands; }
  FrameMode mode() const { return m_mode; }

 private:
  friend class FrameRunner;
  /// CPU time of this thread in stamped frames, else 0: a plain frame asks no clock between passes.
  double threadMs() const;
  /// What recording from `start` on took beyond the passes from `first` on.
  double recordedSince(double start, size_t first) const;

  rhi::CommandList& m_commands;
  FrameQueries& m_queries;
  FrameMode m_mode;
  std::vector<PassResult> m_passes;
};

/// Records a frame with `record`, submits it, waits for it and measures it.
class FrameRunner {
 public:
  FrameRunner(rhi::Device& device, FrameQueries& queries) : m_device(device), m_queries(queries) {}
  FrameResult run(FrameMode mode, const std::function<void(Frame&)>& record);

 private:
  FrameResult runOnce(FrameMode mode, const std::function<void(Frame&)>& record);
  void readStamps(FrameMode mode, FrameResult& result) const;

  rhi::Device& m_device;
  FrameQueries& m_queries;
};

}  // namespace sb
