// Google Benchmark's flags among the arguments. The library ignores bad values or falls back without
// a word; here every flag that it knows is checked before it sees them.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>

#include "base/number.h"
#include "base/pattern.h"
#include "suites/harness/measuring/gbench.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

/// Longest time and most repetitions that may be asked for.
constexpr base::NumberRule kSeconds{.low = 0, .high = 1e6, .above = true};
constexpr base::NumberRule kRepetitions{.low = 1, .high = 1e6, .whole = true};
const std::string kMinTimeForm =
    "seconds above 0, as in 0.5 or 0.5s, or a number of repetitions, as in 5x";

std::string valueOf(const std::string& argument) {
  const size_t equals = argument.find('=');
  return equals == std::string::npos ? "true" : argument.substr(equals + 1);
}

bool isTrue(std::string value) {
  std::ranges::transform(value, value.begin(), [](unsigned char c) { return std::tolower(c); });
  return value == "true" || value == "yes" || value == "on" || value == "1" || value == "t" ||
         value == "y";
}

bool isFalse(std::string value) {
  std::ranges::transform(value, value.begin(), [](unsigned char c) { return std::tolower(c); });
  return value == "false" || value == "no" || value == "off" || value == "0" || value == "f" ||
         value == "n";
}

[[noreturn]] void refuse(const std::string& flag, const std::string& value,
                         const std::string& expected) {
  throw InputError(flag, "found '" + value + "', expected " + expected);
}

void readRepetitions(BenchmarkFlags& flags, const std::string& flag, const std::string& value) {
  const auto count = base::readNumber(value, kRepetitions);
  if (!count) refuse(flag, value, base::describe(kRepetitions));
  flags.repetitions = uint32_t(*count);
}

/// The library of today takes seconds; newer ones "0.5s" and "5x", so many runs of the benchmark.
/// Our runs are blocks.
void readMinTime(BenchmarkFlags& flags, const std::string& flag, const std::string& value) {
  if (value.ends_with('x')) {
    const auto count = base::readNumber(value.substr(0, value.size() - 1), kRepetitions);
    if (!count) refuse(flag, value, kMinTimeForm);
    flags.repetitions = uint32_t(*count);
    return;
  }
  const std::string number = value.ends_with('s') ? value.substr(0, value.size() - 1) : value;
  const auto seconds = base::readNumber(number, kSeconds);
  if (!seconds) refuse(flag, value, kMinTimeForm);
  flags.minSeconds = *seconds;
}

using Read = std::function<void(BenchmarkFlags&, const std::string&, const std::string&)>;

Read oneOf(std::vector<std::string> words) {
  return [words](BenchmarkFlags&, const std::string& flag, const std::string& value) {
    if (std::ranges::find(words, value) == words.end())
      throw InputError(flag, unknownName("value", value, words));
  };
}

/// Flags whose values are checked; the library sees them unless `ours`.
struct Known {
  std::string name;
  Read read;
  bool ours = false;
};

const std::vector<Known>& knownFlags() {
  static const Read onOff = [](BenchmarkFlags&, const std::string& flag, const std::string& value) {
    if (!isTrue(value) && !isFalse(value)) refuse(flag, value, "true or false");
  };
  static const Read colour = [](BenchmarkFlags&, const std::string& flag,
                                const std::string& value) {
    if (value != "auto" && !isTrue(value) && !isFalse(value))
      refuse(flag, value, "true, false or auto");
  };
  static const Read path = [](BenchmarkFlags&, const std::string& flag, const std::string& value) {
    if (value.empty()) refuse(flag, value, "the path of a file");
  };
  static const std::vector<Known> kKnown = {
      {"--benchmark_repetitions", readRepetitions, true},
      {"--benchmark_min_time", readMinTime, true},
      {"--benchmark_format", oneOf({"console", "json", "csv"})},
      {"--benchmark_out_format", oneOf({"console", "json", "csv"})},
      {"--benchmark_out", path},
      {"--benchmark_color", colour},
      {"--benchmark_list_tests", onOff, true},
      {"--benchmark_counters_tabular", onOff},
      {"--benchmark_report_aggregates_only", onOff},
      {"--benchmark_display_aggregates_only", onOff},
      {"--benchmark_enable_random_interleaving", onOff},
  };
  return kKnown;
}

void applyFilter(BenchmarkFlags& flags) {
  // As the library reads it: "all" is every one, a leading '-' leaves out what matches.
  flags.filter = flags.value("--benchmark_filter", "");
  if (flags.filter == "all") flags.filter.clear();
  flags.filterExcludes = flags.filter.starts_with('-');
  if (flags.filterExcludes) flags.filter.erase(0, 1);
}

}  // namespace

std::string BenchmarkFlags::value(const std::string& name, const std::string& fallback) const {
  std::string found = fallback;
  for (const std::string& a : arguments)
    if (a == name || a.starts_with(name + "=")) found = valueOf(a);
  return found;
}

bool BenchmarkFlags::isOn(const std::string& name) const { return isTrue(value(name, "false")); }

BenchmarkFlags takeBenchmarkFlags(std::vector<std::string>& arguments) {
  BenchmarkFlags flags;
  std::vector<std::string> rest, words;
  for (const std::string& a : arguments) {
    if (!a.starts_with("--benchmark_")) {
      rest.push_back(a);
      continue;
    }
    flags.arguments.push_back(a);
    const std::string name = a.substr(0, a.find('='));
    const auto known = std::ranges::find(knownFlags(), name, &Known::name);
    if (known != knownFlags().end()) known->read(flags, name, valueOf(a));
    // Our filter is not the library's, and what it would do with these is done by then.
    const bool ours = name == "--benchmark_filter" || (known != knownFlags().end() && known->ours);
    // The library writes while it goes, and says nothing of a full disk: the file is ours to write.
    if (name == "--benchmark_out")
      words.push_back("--benchmark_out=/dev/null");
    else if (!ours)
      words.push_back(a);
    // Without a format the console's table is ours; these ask for the library's.
    flags.display |= name == "--benchmark_format" || name == "--benchmark_counters_tabular";
  }
  flags.list = flags.isOn("--benchmark_list_tests");
  flags.outFile = flags.value("--benchmark_out", "");
  applyFilter(flags);
  arguments = rest;
  // The library keeps the pointer to the program's name for its reports.
  static std::string program = "bench";
  std::vector<char*> argv = {program.data()};
  for (std::string& w : words) argv.push_back(w.data());
  int argc = int(argv.size());
  benchmark::Initialize(&argc, argv.data());
  if (argc > 1)
    throw InputError(
        "", "unknown option '" + std::string(argv[1]) + "'; Google Benchmark 1.7 does not know it");
  return flags;
}

}  // namespace sb
