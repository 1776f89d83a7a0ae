#include "suites/harness/checks/load_watch.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>

namespace sb {
namespace {

std::optional<uint64_t> throttleEvents() {
  std::optional<uint64_t> sum;
  for (int cpu = 0;; ++cpu) {
    const std::string folder = "/sys/devices/system/cpu/cpu" + std::to_string(cpu);
    std::error_code error;
    if (!std::filesystem::exists(folder, error)) return sum;
    std::ifstream in(folder + "/thermal_throttle/core_throttle_count");
    if (uint64_t count = 0; in >> count) sum = sum.value_or(0) + count;
  }
}

}  // namespace

MachineUse machineUse() {
  MachineUse use;
  std::ifstream in("/proc/stat");
  std::string word;
  in >> word;
  const double tick = 1.0 / double(sysconf(_SC_CLK_TCK));
  // user nice system idle iowait irq softirq steal; guest time is in user already.
  double value = 0;
  for (int i = 0; i < 8 && in >> value; ++i) {
    use.total += value * tick;
    if (i != 3 && i != 4) use.busy += value * tick;
  }
  timespec own{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
  use.own = double(own.tv_sec) + double(own.tv_nsec) * 1e-9;
  use.throttled = throttleEvents();
  return use;
}

std::vector<std::string> disturbances(const MachineUse& before, const MachineUse& after) {
  std::vector<std::string> found;
  const double total = after.total - before.total;
  const double others = (after.busy - before.busy) - (after.own - before.own);
  // Below half a second the ticks of /proc/stat (10 ms each) say too little.
  if (total > 0.5 && others > 0.5 * total)
    found.push_back("other programs used " + std::to_string(std::lround(100 * others / total)) +
                    " % of the CPUs");
  if (before.throttled && after.throttled && *after.throttled > *before.throttled)
    found.push_back("the CPU was throttled");
  return found;
}

}  // namespace sb
