// Are a device's timers worth believing? Facts found by measuring (design, section 6).
#pragma once

#include <string>
#include <vector>

#include "techniques/render/renderer.h"

namespace sb {

/// What cannot be believed if a fact fails.
enum class TimerUse : uint8_t { Frame, Passes };

struct TimerFact {
  std::string name;     ///< "twice the work takes twice the time"
  std::string finding;  ///< with the figure
  bool trusted = false;
  TimerUse use = TimerUse::Frame;
};

/// Draws known loads: a few tenths of a second on a quiet software device. A device that fails is
/// asked again, up to three times: a neighbour can spoil one attempt, a bad timer spoils all.
std::vector<TimerFact> checkTimers(const DeviceContext& context);

/// The first failed fact that concerns `use` as a reason, or "".
std::string whyUntrusted(const std::vector<TimerFact>& facts, TimerUse use);

}  // namespace sb
