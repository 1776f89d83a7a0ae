// Every cell as a Google Benchmark. The block scheduler (group.h) has measured; the registered
// benchmarks replay its blocks as repetitions (manual time, iterations are frames), so that the
// library's flags, statistics and reporters work on them. The CPU time of a replay means nothing:
// reporters get the measured one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/record.h"

namespace sb {

/// Flags of the library among the arguments of the program.
struct BenchmarkFlags {
  std::vector<std::string> arguments;  ///< all --benchmark_* as given
  std::string filter;                  ///< --benchmark_filter
  bool filterExcludes = false;         ///< it began with '-'
  std::string outFile;                 ///< --benchmark_out
  uint32_t repetitions = 0;            ///< --benchmark_repetitions; 0: not given
  double minSeconds = 0;               ///< --benchmark_min_time; 0: not given
  bool list = false;                   ///< --benchmark_list_tests
  bool display = false;                ///< its own output on the console was asked for

  /// The last value of a flag, or `fallback`. A flag without a value is "true".
  std::string value(const std::string& name, const std::string& fallback) const;
  /// As the library reads a flag that is true or false.
  bool isOn(const std::string& name) const;
};

/// Takes the --benchmark_* flags out of `arguments` and lets the library read them. A flag that it
/// does not know, or a bad value, is an InputError.
BenchmarkFlags takeBenchmarkFlags(std::vector<std::string>& arguments);

/// Fills what the library knows of itself and of the machine: its version, the CPU's caches.
void describeLibrary(report::Run& run);

/// Runs the library over the records: prints if display was asked for; gives what --benchmark_out
/// is to hold.
std::string runBenchmarks(const BenchmarkFlags& flags, const std::vector<report::Record>& records);

}  // namespace sb
