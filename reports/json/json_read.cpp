#include "reports/json/json_read.h"

#include <algorithm>

#include "reports/json/json_cell.h"
#include "reports/json/json_figure.h"
#include "reports/json/json_read_error.h"
#include "reports/json/json_stability.h"

namespace report {
namespace {

Run readContext(const Field& c) {
  Run run{.date = textOf(c, "date"),
          .host = textOf(c, "host_name"),
          .executable = textOf(c, "executable"),
          .version = c.at("shadowbench_version").text(),
          .buildType = textOf(c, "library_build_type"),
          .libraryVersion = textOf(c, "library_version"),
          .warnings = textsOf(c, "warnings")};
  run.commit = textOf(c, "commit");
  run.compiler = textOf(c, "compiler");
  run.os = textOf(c, "os");
  run.cpuModel = textOf(c, "cpu_model");
  run.commandLine = textOf(c, "command_line");
  if (auto f = c.find("interrupted")) run.interrupted = f->boolean();
  run.cellsPlanned = countOf(c, "cells_planned");
  run.cellsDone = countOf(c, "cells_done");
  if (auto f = c.find("num_cpus")) run.cpus = f->integer<uint32_t>();
  run.cpuMHz = numberOf(c, "mhz_per_cpu").value_or(0);
  if (auto f = c.find("cpu_scaling_enabled")) run.cpuScaling = f->boolean();
  if (auto f = c.find("caches"))
    for (const Field& cache : f->items())
      run.caches.push_back({.type = cache.at("type").text(),
                            .level = cache.at("level").signedInteger(),
                            .bytes = cache.at("size").integer<uint64_t>(),
                            .sharing = cache.at("num_sharing").integer<uint32_t>()});
  if (auto f = c.find("load_avg"))
    for (const Field& load : f->items()) run.loadAverage.push_back(load.number());
  return run;
}

/// "line 3, column 7" of the byte a parser stopped at, counted from 1.
std::string placeOf(const std::string& text, size_t byte) {
  const std::string before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const size_t line = size_t(std::ranges::count(before, '\n')) + 1;
  const size_t start = before.rfind('\n') == std::string::npos ? 0 : before.rfind('\n') + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - start + 1);
}

}  // namespace

Run fromJson(const std::string& text, const std::string& fileName) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& e) {
    throw ReadError(fileName, "", placeOf(text, e.byte) + ": found no JSON, expected results");
  } catch (const Json::exception&) {
    throw ReadError(fileName, "", "found a number that is too large, expected results");
  }
  const Field root(json, fileName);
  Run run = readContext(root.at("context"));
  run.records = readRecords(root.at("benchmarks"));
  if (const auto cases = root.find("stability"))
    for (const Field& field : cases->items()) run.stability.push_back(readStability(field));
  if (const auto figures = root.find("figures"))
    for (const Field& field : figures->items()) run.figures.push_back(readFigure(field));
  // Files from before figures said it: of what was measured the records know.
  for (Figure& figure : run.figures)
    for (FigureCell& cell : figure.cells)
      for (const Record& r : run.records)
        if (cell.backend.empty() && r.name == cell.name) cell.backend = r.id.backend;
  return run;
}

}  // namespace report
