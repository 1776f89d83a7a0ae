// The captured frame drawn straight through an API: what someone would write who knows this one
// frame. One call a mesh; what does not change is not set again.
#pragma once

#include "tests/baseline/capture.h"

namespace sb::baseline {

class ByHand {
 public:
  virtual ~ByHand() = default;
  /// Records and submits, without waiting.
  virtual void submit() = 0;
  virtual void wait() = 0;
  /// RGBA16Float texels, row 0 = clip y -1.
  virtual std::vector<std::byte> picture() = 0;
};

std::unique_ptr<ByHand> makeVulkan(const Capture& capture);
std::unique_ptr<ByHand> makeOpengl(const Capture& capture);

}  // namespace sb::baseline
