#include "reports/record.h"

#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string_view>
#include <thread>

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

/// Of this process, in words that a shell reads again.
std::string commandLine() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::string line;
  for (std::string word; std::getline(file, word, '\0');) {
    const bool plain = !word.empty() && word.find_first_not_of(
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_=+.,/:@%") == word.npos;
    std::string quoted;
    for (char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += (line.empty() ? "" : " ") + (plain ? word : "'" + quoted + "'");
  }
  return line;
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
  run.commandLine = commandLine();
  run.version = version;
#ifdef NDEBUG
  run.buildType = "release";
#else
  run.buildType = "debug";
#endif
  run.cpus = std::thread::hardware_concurrency();
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("cpu MHz")) {
      run.cpuMHz = std::strtod(line.c_str() + line.find(':') + 1, nullptr);
      break;
    }
  std::string governor;
  std::ifstream("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor") >> governor;
  run.cpuScaling = !governor.empty() && governor != "performance";
  double load[3];
  if (getloadavg(load, 3) == 3) run.loadAverage.assign(load, load + 3);
  return run;
}

}  // namespace report
