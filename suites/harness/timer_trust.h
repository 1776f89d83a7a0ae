// Are a device's timers worth believing? Facts found by measuring (design, section 6).
#pragma once

#include <string>
#include <vector>

#include "techniques/common/renderer.h"

namespace sb {

struct TimerFact {
  std::string name;     ///< "twice the work takes twice the time"
  std::string finding;  ///< with the figure
  bool trusted = false;
};

/// Draws known loads: takes about a second on a software device.
std::vector<TimerFact> checkTimers(const DeviceContext& context);

}  // namespace sb
