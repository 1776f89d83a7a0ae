// How many samples each of a technique's passes drew, known one frame later: how peeling learns
// where it may stop. The runner waits for each frame, so that the next one finds the numbers there.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "backends/rhi/device.h"

namespace sb {

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
