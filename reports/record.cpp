#include "reports/record.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <string_view>
#include <thread>

#include "base/number.h"
#include "reports/build_facts.h"

namespace report {

std::string_view certificateVerdict(const Certificate& certificate) {
  if (!certificate.unbiased) return "undecided";
  return *certificate.unbiased ? "unbiased" : "biased";
}

std::string_view statusName(Status status) {
  static constexpr std::string_view kNames[] = {"ok", "skipped", "failed"};
  return kNames[size_t(status)];
}

void refuse(Record& record, const std::string& reason) {
  record.status = Status::Failed;
  record.reason = reason;
  record.timeSource.clear();
  record.frame = record.wall = record.cpu = record.record = record.device_ = {};
  record.submitMs = record.compileMs = record.precision = {};
  record.shadowMs = record.sceneMs = record.combinedMs = record.stampedFrameMs = {};
  record.stoppedBy.clear();
  record.passes.clear();
  record.ratios.clear();
  record.blocks.clear();
}

namespace {

/// "Debian GNU/Linux 12 (bookworm), Linux 6.1.0".
std::string operatingSystem() {
  std::string name;
  std::ifstream release("/etc/os-release");
  for (std::string line; std::getline(release, line);)
    if (line.starts_with("PRETTY_NAME=")) name = line.substr(12);
  std::erase(name, '"');
  utsname kernel{};
  if (uname(&kernel) != 0) return name;
  return name + (name.empty() ? "" : ", ") + kernel.sysname + " " + kernel.release;
}

}  // namespace

Run describeMachine(const std::string& executable, const std::string& version) {
  Run run;
  char text[256] = "";
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S%z", &local);
  run.date = text;
  if (gethostname(text, sizeof text) == 0) run.host = text;
  run.executable = executable;
  run.version = version;
#ifdef NDEBUG
  run.buildType = "release";
#else
  run.buildType = "debug";
#endif
  run.cpus = std::thread::hardware_concurrency();
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line) && !line.empty();) {
    const std::string value = line.substr(std::min(line.size(), line.find(':') + 2));
    if (line.starts_with("cpu MHz")) run.cpuMHz = base::readNumber(value, {}).value_or(0);
    if (line.starts_with("model name")) run.cpuModel = value;
  }
  run.commit = SHADOWBENCH_COMMIT;
  run.compiler = SHADOWBENCH_COMPILER;
  run.os = operatingSystem();
  std::string governor;
  std::ifstream("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor") >> governor;
  run.cpuScaling = !governor.empty() && governor != "performance";
  double load[3];
  if (getloadavg(load, 3) == 3) run.loadAverage.assign(load, load + 3);
  return run;
}

}  // namespace report
