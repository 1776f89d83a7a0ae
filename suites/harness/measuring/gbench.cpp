#include "suites/harness/measuring/gbench.h"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cmath>
#include <map>
#include <memory>
#include <sstream>

#include "reports/stats/stats.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

using benchmark::BenchmarkReporter;

/// Hands runs on with the cell's name and its measured CPU time.
class Corrected final : public BenchmarkReporter {
 public:
  Corrected(std::unique_ptr<BenchmarkReporter> inner, const std::vector<report::Record>& records)
      : m_inner(std::move(inner)) {
    for (const report::Record& r : records) m_records[r.name] = &r;
  }
  /// With `text`: what is reported goes there, not to the library's stream.
  void keepIn(std::ostream& text) { m_text = &text; }
  bool ReportContext(const Context& context) override {
    m_inner->SetOutputStream(m_text ? m_text : &GetOutputStream());
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
  std::ostream* m_text = nullptr;
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

std::unique_ptr<BenchmarkReporter> makeReporter(const BenchmarkFlags& flags,
                                                const std::string& format, bool toFile) {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  if (format == "csv") return std::make_unique<benchmark::CSVReporter>();
#pragma GCC diagnostic pop
  if (format == "json") return std::make_unique<benchmark::JSONReporter>();
  int options = benchmark::ConsoleReporter::OO_None;
  if (flags.isOn("--benchmark_counters_tabular"))
    options |= benchmark::ConsoleReporter::OO_Tabular;
  const std::string color = flags.value("--benchmark_color", "auto");
  if (!toFile && (color == "auto" ? isatty(1) != 0 : flags.isOn("--benchmark_color")))
    options |= benchmark::ConsoleReporter::OO_Color;
  return std::make_unique<benchmark::ConsoleReporter>(
      benchmark::ConsoleReporter::OutputOptions(options));
}

}  // namespace

void describeLibrary(report::Run& run) {
  run.libraryVersion = "v" SHADOWBENCH_BENCHMARK_VERSION;
  for (const auto& c : benchmark::CPUInfo::Get().caches)
    run.caches.push_back({.type = c.type,
                          .level = c.level,
                          .bytes = uint64_t(c.size),
                          .sharing = uint32_t(c.num_sharing)});
}

std::string runBenchmarks(const BenchmarkFlags& flags,
                          const std::vector<report::Record>& records) {
  std::ostringstream text;
  if (flags.arguments.empty() || records.empty()) return "";
  benchmark::ClearRegisteredBenchmarks();
  for (const report::Record& r : records) registerCell(r);
  Corrected display(
      flags.display ? makeReporter(flags, flags.value("--benchmark_format", "console"), false)
                    : std::make_unique<Silent>(),
      records);
  std::unique_ptr<Corrected> file;
  if (!flags.outFile.empty())
    file = std::make_unique<Corrected>(
        makeReporter(flags, flags.value("--benchmark_out_format", "json"), true), records);
  if (file) file->keepIn(text);
  // The filter has been applied to the selection already.
  benchmark::RunSpecifiedBenchmarks(&display, file.get(), ".");
  benchmark::ClearRegisteredBenchmarks();
  return text.str();
}

}  // namespace sb
