#include "suites/harness/gbench.h"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>

#include "reports/stats/stats.h"
#include "techniques/common/error.h"

namespace sb {
namespace {

using benchmark::BenchmarkReporter;

std::string flagValue(const std::string& argument) {
  const size_t equals = argument.find('=');
  return equals == std::string::npos ? "true" : argument.substr(equals + 1);
}

double positiveNumber(const std::string& argument) {
  char* end = nullptr;
  const std::string text = flagValue(argument);
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end || !(value > 0))
    throw InputError(argument.substr(0, argument.find('=')),
                     "found '" + text + "', expected a number above 0");
  return value;
}

/// Hands runs on with the cell's name and its measured CPU time.
class Corrected final : public BenchmarkReporter {
 public:
  Corrected(std::unique_ptr<BenchmarkReporter> inner, const std::vector<report::Record>& records)
      : m_inner(std::move(inner)) {
    for (const report::Record& r : records) m_records[r.name] = &r;
  }
  bool ReportContext(const Context& context) override {
    m_inner->SetOutputStream(&GetOutputStream());
    m_inner->SetErrorStream(&GetErrorStream());
    return m_inner->ReportContext(context);
  }
  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> corrected = runs;
    for (Run& run : corrected) correct(run);
    m_inner->ReportRuns(corrected);
  }
  void Finalize() override { m_inner->Finalize(); }

 private:
  void correct(Run& run) const {
    run.run_name.iterations.clear();
    run.run_name.repetitions.clear();
    run.run_name.time_type.clear();
    // The library's coefficient of variation of what is 0 is 0/0, which is no JSON.
    std::erase_if(run.counters, [](const auto& c) { return !std::isfinite(c.second.value); });
    if (!std::isfinite(run.real_accumulated_time)) run.real_accumulated_time = 0;
    auto found = m_records.find(run.run_name.function_name);
    if (found == m_records.end() || run.error_occurred) return;
    std::vector<double> cpu;
    for (const report::Block& b : found->second->blocks) cpu.push_back(b.cpuMs * 1e-3);
    if (run.run_type == Run::RT_Iteration) {
      const size_t index = size_t(std::max<int64_t>(0, run.repetition_index)) % cpu.size();
      run.cpu_accumulated_time = cpu[index] * double(run.iterations);
      return;
    }
    const report::Distribution d = report::distribution(cpu);
    double mean = 0;
    for (double c : cpu) mean += c / double(cpu.size());
    const double value = run.aggregate_name == "mean"     ? mean
                         : run.aggregate_name == "median" ? d.median
                         : run.aggregate_name == "stddev" ? d.cv * mean
                                                          : d.cv;
    run.cpu_accumulated_time = run.aggregate_unit == benchmark::StatisticUnit::kTime
                                   ? value * double(run.iterations)
                                   : value;
  }

  std::unique_ptr<BenchmarkReporter> m_inner;
  std::map<std::string, const report::Record*> m_records;
};

class Silent final : public BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>&) override {}
};

void replay(benchmark::State& state, const report::Record& record, size_t& next) {
  if (record.status != report::Status::Ok) {
    state.SkipWithError(record.reason.c_str());
    return;
  }
  const report::Block& block = record.blocks[next++ % record.blocks.size()];
  for (auto _ : state) state.SetIterationTime(block.frameMs * 1e-3);
  auto count = [&](const char* name, const auto& value) {
    if (value) state.counters[name] = double(*value);
  };
  auto median = [&](const char* name, const std::optional<report::Distribution>& d) {
    if (d) state.counters[name] = d->median;
  };
  median("wall_ms", record.wall);
  median("record_ms", record.record);
  count("submit_ms", record.submitMs);
  count("shadow_ms", record.shadowMs);
  count("scene_ms", record.sceneMs);
  if (record.visibility) state.counters["visibility_rmse"] = record.visibility->all.rmse;
  if (record.visibility) count("visibility_weighted_rmse", record.visibility->weighted);
  if (record.image) state.counters["image_rmse"] = record.image->all.rmse;
  if (record.image) state.counters["flip"] = record.image->flip;
  state.counters["passes"] = double(record.passCount);
  state.counters["draws"] = double(record.drawCount);
  state.counters["triangles"] = double(record.triangleCount);
  state.counters["bytes"] = double(record.bytes);
}

void registerCell(const report::Record& record) {
  const bool ok = record.status == report::Status::Ok;
  auto* entry = benchmark::RegisterBenchmark(
      record.name.c_str(), [&record, next = size_t(0)](benchmark::State& state) mutable {
        replay(state, record, next);
      });
  entry->UseManualTime()
      ->Unit(benchmark::kMicrosecond)
      ->Iterations(ok ? std::max(1u, record.blocks.front().frames) : 1)
      ->Repetitions(ok ? int(record.blocks.size()) : 1);
}

/// The value of the last flag of that name, or `fallback`.
std::string lastValue(const BenchmarkFlags& flags, const std::string& name,
                      const std::string& fallback) {
  std::string value = fallback;
  for (const std::string& a : flags.arguments)
    if (a == name || a.starts_with(name + "=")) value = flagValue(a);
  return value;
}

bool isTrue(const std::string& value) {
  return value == "true" || value == "yes" || value == "on" || value == "1" || value == "t";
}

std::unique_ptr<BenchmarkReporter> makeReporter(const BenchmarkFlags& flags,
                                                const std::string& format, bool toFile) {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  if (format == "csv") return std::make_unique<benchmark::CSVReporter>();
#pragma GCC diagnostic pop
  if (format == "json") return std::make_unique<benchmark::JSONReporter>();
  int options = benchmark::ConsoleReporter::OO_None;
  if (isTrue(lastValue(flags, "--benchmark_counters_tabular", "false")))
    options |= benchmark::ConsoleReporter::OO_Tabular;
  const std::string color = lastValue(flags, "--benchmark_color", "auto");
  if (!toFile && (color == "auto" ? isatty(1) != 0 : isTrue(color)))
    options |= benchmark::ConsoleReporter::OO_Color;
  return std::make_unique<benchmark::ConsoleReporter>(
      benchmark::ConsoleReporter::OutputOptions(options));
}

}  // namespace

BenchmarkFlags takeBenchmarkFlags(std::vector<std::string>& arguments) {
  BenchmarkFlags flags;
  std::vector<std::string> rest;
  for (const std::string& a : arguments) {
    if (!a.starts_with("--benchmark_")) {
      rest.push_back(a);
      continue;
    }
    flags.arguments.push_back(a);
    if (a.starts_with("--benchmark_repetitions="))
      flags.repetitions = uint32_t(std::max(1.0, positiveNumber(a)));
    if (a.starts_with("--benchmark_min_time=")) flags.minSeconds = positiveNumber(a);
    // Without a format the console's table is ours; these ask for the library's.
    for (const char* name : {"--benchmark_format", "--benchmark_counters_tabular"})
      flags.display |= a.starts_with(name);
  }
  flags.list = isTrue(lastValue(flags, "--benchmark_list_tests", "false"));
  flags.outFile = lastValue(flags, "--benchmark_out", "");
  // As the library reads it: "all" is every one, a leading '-' leaves out what matches.
  flags.filter = lastValue(flags, "--benchmark_filter", "");
  if (flags.filter == "all") flags.filter.clear();
  flags.filterExcludes = flags.filter.starts_with('-');
  if (flags.filterExcludes) flags.filter.erase(0, 1);
  arguments = rest;
  // The library keeps the pointer to the program's name for its reports.
  static std::string program = "bench";
  std::vector<std::string> words = flags.arguments;
  std::vector<char*> argv = {program.data()};
  for (std::string& w : words) argv.push_back(w.data());
  int argc = int(argv.size());
  benchmark::Initialize(&argc, argv.data());
  if (argc > 1)
    throw InputError(
        "", "unknown option '" + std::string(argv[1]) + "'; Google Benchmark 1.7 does not know it");
  return flags;
}

void describeLibrary(report::Run& run) {
  run.libraryVersion = "v" SHADOWBENCH_BENCHMARK_VERSION;
  for (const auto& c : benchmark::CPUInfo::Get().caches)
    run.caches.push_back({.type = c.type,
                          .level = c.level,
                          .bytes = uint64_t(c.size),
                          .sharing = uint32_t(c.num_sharing)});
}

void runBenchmarks(const BenchmarkFlags& flags, const std::vector<report::Record>& records) {
  if (flags.arguments.empty() || records.empty()) return;
  benchmark::ClearRegisteredBenchmarks();
  for (const report::Record& r : records) registerCell(r);
  Corrected display(
      flags.display ? makeReporter(flags, lastValue(flags, "--benchmark_format", "console"), false)
                    : std::make_unique<Silent>(),
      records);
  std::unique_ptr<Corrected> file;
  if (!flags.outFile.empty())
    file = std::make_unique<Corrected>(
        makeReporter(flags, lastValue(flags, "--benchmark_out_format", "json"), true), records);
  // The filter has been applied to the selection already.
  benchmark::RunSpecifiedBenchmarks(&display, file.get(), ".");
  benchmark::ClearRegisteredBenchmarks();
}

}  // namespace sb
