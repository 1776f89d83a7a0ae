// What else happened on the machine between two moments: CPU time of other programs (and of other
// machines on the same host), and thermal throttling.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sb {

/// Seconds and counts since boot; absent where the system does not tell.
struct MachineUse {
  double total = 0;                   ///< CPU time that was there, idle or not, all CPUs
  double busy = 0;                    ///< of it used, or stolen by the hypervisor
  double own = 0;                     ///< used by this process
  std::optional<uint64_t> throttled;  ///< thermal throttling events, all CPUs
};
MachineUse machineUse();

/// Reasons to mistrust times taken between the two; empty for a quiet machine. The load of others
/// counts from half of the machine on: below that, interleaving and CPU time cope with it.
std::vector<std::string> disturbances(const MachineUse& before, const MachineUse& after);

}  // namespace sb
