#include "reports/console/console.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "reports/console/console_names.h"
#include "reports/console/console_table.h"
#include "reports/record_view.h"

namespace report {
namespace {

constexpr size_t kColumns = 16;
using Row = std::array<std::string, kColumns>;

const Row kHeader = {"cell",        "frame ms", "CPU ms",   "±",     "x none [95 %]", "x other API",
                     "error",       "by light", "noise",    "image", "FLIP",          "shadow ms",
                     "scene ms",    "passes/draws", "MiB",  "picture"};

/// Drivers' texts have line breaks.
std::string oneLine(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::string milliseconds(const std::optional<double>& ms) {
  return ms ? fmt::format("{:.2f}", *ms) : "-";
}

std::string median(const std::optional<Distribution>& d) {
  return d ? fmt::format("{:.2f}", d->median) : "-";
}

std::string ratio(const Record& r, const std::string& kind) {
  for (const Ratio& x : r.ratios)
    if (x.kind == kind)
      return x.low < x.high ? fmt::format("{:.2f} [{:.2f},{:.2f}]", x.value, x.low, x.high)
                            : fmt::format("{:.2f} [none]", x.value);
  return "-";
}

std::string verified(const Record& r) {
  if (r.status != Status::Ok) return std::string(statusName(r.status)) + ": " + oneLine(r.reason);
  std::string text = "stable";
  if (r.crossBackendOver1.value_or(0) > 0)
    text += fmt::format(", APIs DIFFER: {} px, {}/255", *r.crossBackendOver1,
                        r.crossBackendMax255.value_or(0));
  else if (r.crossBackendMax255)
    text += fmt::format(", {}/255", *r.crossBackendMax255);
  if (!r.contamination.empty()) text += ", CONTAMINATED";
  return text;
}

Row rowOf(const Record& r, CellNames& names) {
  Row row;
  row.fill("-");
  row.front() = names.shown(r);
  row.back() = verified(r);
  if (r.status != Status::Ok) return row;
  row[1] = median(r.frame);
  row[2] = median(r.cpu);
  if (r.precision) row[3] = fmt::format("{:.0f}%", 100 * *r.precision);
  row[4] = ratio(r, "baseline");
  row[5] = ratio(r, "backend");
  if (r.visibility)
    row[6] = fmt::format("{}{:.4f}", belowTruth(r) ? "~" : "", r.visibility->all.rmse);
  if (r.visibility && r.visibility->weighted)
    row[7] = fmt::format("{:.4f}", *r.visibility->weighted);
  if (r.noise) row[8] = fmt::format("{:.4f}", r.noise->noise);
  if (r.image) row[9] = fmt::format("{:.4f}", r.image->all.rmse);
  if (r.image) row[10] = fmt::format("{:.4f}", r.image->flip);
  row[11] = milliseconds(r.shadowMs);
  row[12] = milliseconds(r.sceneMs);
  row[13] = fmt::format("{}/{}", r.passCount, r.drawCount);
  row[14] = fmt::format("{:.1f}", double(r.bytes) / (1 << 20));
  return row;
}

std::string lines(const std::vector<Row>& rows) {
  std::array<size_t, kColumns> widths{};
  for (const Row& r : rows)
    for (size_t i = 0; i + 1 < kColumns; ++i) widths[i] = std::max(widths[i], seenWidth(r[i]));
  std::string out;
  for (const Row& row : rows) {
    for (size_t i = 0; i < kColumns; ++i) {
      const std::string pad(widths[i] > seenWidth(row[i]) ? widths[i] - seenWidth(row[i]) : 0, ' ');
      out += (i ? "  " : "") + (i == 0 || i + 1 == kColumns ? row[i] + pad : pad + row[i]);
    }
    out += "\n";
  }
  return out;
}

/// What the figures are and where they come from.
std::string legend(const Run& run) {
  std::set<std::string> sources, devices;
  size_t ok = 0, byBudget = 0;
  for (const Record& r : run.records) {
    if (r.status != Status::Ok) continue;
    devices.insert(
        fmt::format("{}: {} ({}), driver {}", r.id.backend, r.device, r.deviceType, r.driver));
    sources.insert(r.timeSource);
    ++ok;
    byBudget += r.stoppedBy == "budget";
  }
  std::string out;
  for (const std::string& d : devices) out += d + "\n";
  if (sources.contains("software"))
    out +=
        "Software devices: frame = wall time to completion, CPU = time of all threads; ± and the "
        "ratios are of CPU time. These figures say nothing about graphics hardware.\n";
  if (std::ranges::any_of(run.records, [](const Record& r) { return r.visibility.has_value(); }))
    out +=
        "Against the ray-traced truth: error = RMSE of visibility; by light = the same, each pixel "
        "weighed by the light that it would reflect unshadowed; noise = its standard deviation over "
        "seeds; image = RMSE of the picture, FLIP = its mean.\n";
  if (std::ranges::any_of(run.records, belowTruth))
    out += "~: less than three standard errors of the truth, which cannot tell it from 0.\n";
  if (sources.contains("gpu-timestamp"))
    out += "Frame times are GPU timestamps; ± and the ratios are of them.\n";
  if (sources.contains("wall"))
    out += "Frame times are wall times to completion: the device has no timestamps.\n";
  if (byBudget > 0)
    out += fmt::format("{} of {} cells stopped by the budget before the precision asked for.\n",
                       byBudget, ok);
  return out;
}

/// The same words of several cells stand once.
std::string warnings(const Run& run) {
  std::string out;
  for (const std::string& text : unshownEffects(run)) out += "warning: " + text + "\n";
  for (const std::string& w : run.warnings) out += "warning: " + oneLine(w) + "\n";
  std::vector<std::pair<std::string, std::vector<std::string>>> byText;
  auto add = [&](const std::string& text, const std::string& name) {
    auto found = std::ranges::find(byText, text, [](const auto& e) { return e.first; });
    if (found == byText.end()) found = byText.insert(byText.end(), {text, {}});
    found->second.push_back(name);
  };
  for (const Record& r : run.records) {
    // Errors that are all absent for one reason: of the scene, not of the cell.
    if (const auto why = r.why.find("image"); r.status == Status::Ok && why != r.why.end())
      add("no error: " + oneLine(why->second), r.name);
    for (const std::string& c : r.contamination) add("contaminated, in no ratio: " + c, r.name);
    for (const std::string& w : r.warnings) add(oneLine(w), r.name);
  }
  for (const auto& [text, names] : byText)
    out += names.size() == 1 ? fmt::format("warning: {}: {}\n", names.front(), text)
                             : fmt::format("warning: {} cells: {}\n", names.size(), text);
  return out;
}

}  // namespace

std::string toTable(const Run& run) {
  std::vector<Row> rows = {kHeader};
  CellNames names;
  for (const Record& r : run.records) rows.push_back(rowOf(r, names));
  return lines(rows) + names.legend() + legend(run) + warnings(run);
}

}  // namespace report
