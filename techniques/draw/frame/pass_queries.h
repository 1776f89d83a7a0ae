// How many samples each of a technique's passes drew, known one frame later: how peeling learns
// where it may stop. The runner waits for each frame, so that the next one finds the numbers there.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "backends/rhi/device.h"

namespace sb {

/// What PassQueries counted at each step of a camera's path, the last time that it stood there: of
/// a standing camera a frame earlier, of one in motion a loop earlier.
class PassesAtSteps {
 public:
  /// `samples`: of the frame that the last call was for. Returns those of `step`, or nothing.
  std::vector<uint64_t> next(std::vector<uint64_t> samples, uint32_t step) {
    if (m_last) m_samples[*m_last] = std::move(samples);
    m_last = step;
    return m_samples[step];
  }

 private:
  std::optional<uint32_t> m_last;
  std::map<uint32_t, std::vector<uint64_t>> m_samples;
};

class PassQueries {
 public:
  PassQueries() = default;
  /// At most `most` passes a frame. Needs Feature::PreciseOcclusion.
  PassQueries(rhi::Device& device, const std::string& label, uint32_t most);

  /// Draws within the open pass and counts; call once for each pass, first to last.
  void count(rhi::CommandList& commands, const std::function<void()>& draws);
  /// Samples of the passes of the last finished frame, first to last, and starts over. Empty when
  /// there was none.
  std::vector<uint64_t> take();
  /// The same without starting over.
  std::vector<uint64_t> look() const;

 private:
  rhi::Device* m_device = nullptr;
  rhi::QueryPool m_pool;
  uint32_t m_counted = 0;
};

}  // namespace sb
