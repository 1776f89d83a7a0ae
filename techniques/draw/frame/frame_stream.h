// Frames for people to look at: each is recorded and submitted, and none is waited for but the one
// whose storage the next needs (rhi::kFramesInFlight). Nothing is measured; FrameRunner does that.
#pragma once

#include <functional>

#include "techniques/draw/frame/frame.h"

namespace sb {

class FrameStream {
 public:
  FrameStream(rhi::Device& device, FrameQueries& queries) : m_device(device), m_queries(queries) {}

  /// Waits at most until the device has taken up the last frame but rhi::kFramesInFlight - 1,
  /// records a frame with `record` and submits it. Of a frame in which `record` throws nothing is
  /// executed.
  rhi::Ticket submit(const std::function<void(Frame&)>& record) {
    rhi::FrameScope scope(m_device);
    Frame frame(scope.commands(), m_queries, FrameMode::Plain);
    record(frame);
    return scope.end();
  }

 private:
  rhi::Device& m_device;
  FrameQueries& m_queries;
};

}  // namespace sb
