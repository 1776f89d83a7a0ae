#include "reports/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace report {
namespace {

using Row = std::array<std::string, 9>;

std::string milliseconds(const std::optional<Distribution>& d) {
  if (!d) return "-";
  return fmt::format("{:.2f} ±{:.0f}%", d->median,
                     d->median > 0 ? 50 * (d->q3 - d->q1) / d->median : 0.0);
}

std::string ratio(const Record& r, const std::string& technique) {
  for (const Ratio& x : r.ratios)
    if (x.against.starts_with(technique + "/" + r.backend + "/"))
      return fmt::format("{:.2f} [{:.2f},{:.2f}]", x.value, x.low, x.high);
  return "-";
}

std::string verified(const Record& r) {
  if (r.status != Status::Ok) return std::string(statusName(r.status));
  std::string text = "stable";
  if (r.crossBackendMax255) text += fmt::format(", {}/255", *r.crossBackendMax255);
  return text;
}

Row row(const Record& r) {
  if (r.status != Status::Ok)
    return {r.name, "-", "-", "-", "-", "-", "-", "-", verified(r) + ": " + r.reason};
  return {r.name,
          milliseconds(r.frame),
          milliseconds(r.cpu),
          ratio(r, "none"),
          r.shadowMs ? fmt::format("{:.2f}", *r.shadowMs) : "-",
          r.sceneMs ? fmt::format("{:.2f}", *r.sceneMs) : "-",
          fmt::format("{}/{}", r.passCount, r.drawCount),
          fmt::format("{:.1f}", double(r.bytes) / (1 << 20)),
          verified(r)};
}

}  // namespace

std::string toTable(const Run& run) {
  std::vector<Row> rows = {{"cell", "frame ms", "CPU ms", "x none (95 %)", "shadow ms", "scene ms",
                            "passes/draws", "MiB", "picture"}};
  for (const Record& r : run.records) rows.push_back(row(r));
  std::array<size_t, 9> widths{};
  for (const Row& r : rows)
    for (size_t i = 0; i + 1 < r.size(); ++i) widths[i] = std::max(widths[i], r[i].size());
  std::string out;
  for (size_t line = 0; line < rows.size(); ++line) {
    for (size_t i = 0; i < rows[line].size(); ++i) {
      const std::string& cell = rows[line][i];
      // UTF-8: pad by what is seen, not by bytes.
      const size_t seen = size_t(std::ranges::count_if(cell, [](char c) { return (c & 0xC0) != 0x80; }));
      const std::string pad(widths[i] > seen && i + 1 < rows[line].size() ? widths[i] - seen : 0, ' ');
      out += (i ? "  " : "") + (i == 0 || i + 1 == rows[line].size() ? cell + pad : pad + cell);
    }
    out += "\n";
  }
  std::set<std::string> sources, devices;
  for (const Record& r : run.records)
    if (r.status == Status::Ok) {
      devices.insert(fmt::format("{}: {} ({}), driver {}", r.backend, r.device, r.deviceType, r.driver));
      sources.insert(r.timeSource);
    }
  for (const std::string& d : devices) out += d + "\n";
  if (sources.contains("software"))
    out += "Times of software devices are wall time to completion and CPU time of all threads; the "
           "ratios are of CPU time. They are not GPU times.\n";
  if (sources.contains("gpu-timestamp")) out += "Frame times are GPU timestamps.\n";
  for (const std::string& w : run.warnings) out += "warning: " + w + "\n";
  for (const Record& r : run.records)
    for (const std::string& w : r.warnings) out += "warning: " + r.name + ": " + w + "\n";
  return out;
}

}  // namespace report
