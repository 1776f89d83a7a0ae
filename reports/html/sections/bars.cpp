// Bars: time of each pass, memory by label, one backend over another. Drawn by plain elements, so
// that they stand without scripts and sort with their tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

struct Part {
  std::string label;
  double amount;
  std::string text;  ///< the amount with its unit
};

double total(const std::vector<Part>& parts) {
  double sum = 0;
  for (const Part& p : parts) sum += p.amount;
  return sum;
}

/// A bar whose whole width is `most`; what is longer fades out at the end.
std::string bar(const std::string& style, const std::vector<Part>& parts, double most) {
  const double sum = total(parts);
  const double whole = std::max(most, sum);
  std::string out =
      "<span class=\"bar " + style + (sum > most ? " clipped" : "") + "\" aria-hidden=\"true\">";
  for (const Part& p : parts)
    if (p.amount > 0)
      out += fmt::format("<span style=\"width:{:.2f}%\" title=\"{}: {}\"></span>",
                         100 * p.amount / whole, escaped(p.label), escaped(p.text));
  return out + "</span>";
}

std::string words(const std::vector<Part>& parts) {
  std::string out;
  for (const Part& p : parts)
    out += (out.empty() ? "" : " · ") + escaped(p.label) + "&nbsp;" + escaped(p.text);
  return out;
}

/// A table of cells with a bar each; cells without parts are left out.
template <class PartsOf>
std::string barTable(const PageModel& model, const ScenePart& part, const std::string& caption,
                     const std::string& unit, const std::string& words_, const PartsOf& partsOf,
                     std::string (*figureOf)(double)) {
  double most = 0;
  for (size_t index : part.cells) {
    const Record& r = model.run.records[index];
    // A ray tracer's row would leave nothing of the others.
    if (r.role != Role::Tracer) most = std::max(most, total(partsOf(r)));
  }
  std::vector<TableLine> lines;
  for (size_t index : part.cells) {
    const Record& r = model.run.records[index];
    const std::vector<Part> parts = partsOf(r);
    if (parts.empty()) continue;
    TableLine line = cellLine(model, r);
    line.cells.push_back({.html = figureOf(total(parts)), .value = total(parts)});
    line.cells.push_back({.html = bar(model.colorClass(techniqueOf(r)), parts, most) + "<small>" +
                                  words(parts) + "</small>",
                          .value = total(parts)});
    lines.push_back(std::move(line));
  }
  if (lines.empty()) return "";
  std::vector<TableColumn> columns = cellColumns();
  columns.push_back({unit, true});
  columns.push_back({words_});
  return tableHtml(caption, columns, lines, "bars");
}

std::vector<Part> passParts(const Record& r) {
  std::vector<Part> out;
  for (const PassRecord& p : r.passes) out.push_back({p.count > 1 ? std::to_string(p.count) + " x " + p.label : p.label, p.ms, figure(p.ms) + " ms"});
  return out;
}

std::vector<Part> memoryParts(const Record& r) {
  // Small buffers would hide the large ones behind their names.
  constexpr uint64_t kSmall = 200;
  std::vector<Part> out;
  uint64_t rest = 0;
  size_t small = 0;
  for (const auto& [label, bytes] : r.bytesByLabel)
    if (bytes < r.bytes / kSmall)
      rest += bytes, ++small;
    else
      out.push_back({label, double(bytes), mebibytes(bytes) + " MiB"});
  std::ranges::stable_sort(out, std::greater(), &Part::amount);
  if (small > 0)
    out.push_back({counted(small, "smaller", "smaller"), double(rest), mebibytes(rest) + " MiB"});
  return out;
}

/// Interval and value on a logarithmic axis from 1/most to most.
std::string ratioMark(const Ratio& x, double most) {
  const auto place = [&](double v) {
    return std::clamp(50 + 50 * std::log(std::max(v, 1e-9)) / std::log(most), 0.0, 100.0);
  };
  return fmt::format(
      "<span class=\"ratio\" aria-hidden=\"true\"><span class=\"range\" "
      "style=\"left:{:.2f}%;width:{:.2f}%\"></span><span class=\"mark\" "
      "style=\"left:{:.2f}%\"></span></span>",
      place(x.low), place(x.high) - place(x.low), place(x.value));
}

struct Comparison {
  const Record* cell;
  const Ratio* ratio;
  std::string other;  ///< backend
};

/// Each pair once, from Vulkan's side where it has one.
std::vector<Comparison> comparisons(const PageModel& model, const ScenePart& part) {
  std::vector<Comparison> out;
  std::set<std::pair<std::string, std::string>> seen;
  for (const bool vulkan : {true, false})
    for (size_t index : part.cells) {
      const Record& r = model.run.records[index];
      if ((r.id.backend == "vulkan") != vulkan) continue;
      for (const Ratio& x : r.ratios) {
        if (x.kind != "backend" || seen.contains({x.against, r.name})) continue;
        seen.insert({r.name, x.against});
        const auto other = std::ranges::find(model.run.records, x.against, &Record::name);
        out.push_back({&r, &x, other == model.run.records.end() ? x.against : other->id.backend});
      }
    }
  return out;
}

std::string verdict(const Record& r, const Ratio& x, const std::string& other) {
  if (x.low <= 1 && x.high >= 1) return "no difference shown";
  const bool faster = x.value < 1;
  return (faster ? r.id.backend : other) + " is faster";
}

}  // namespace

std::string passBars(const PageModel& model, const ScenePart& part) {
  return barTable(model, part, "Time of each pass, medians of frames that carry stamps", "ms",
                  "Passes", passParts, [](double v) { return figure(v); });
}

std::string memoryBars(const PageModel& model, const ScenePart& part) {
  return barTable(model, part, "Memory that a cell alone keeps on the device", "MiB", "What for",
                  memoryParts, [](double v) { return mebibytes(uint64_t(v)); });
}

std::string backendRatios(const PageModel& model, const ScenePart& part) {
  const auto all = comparisons(model, part);
  if (all.empty()) return "";
  double most = 1.25;
  for (const Comparison& c : all)
    most = std::max({most, c.ratio->high, 1 / std::max(c.ratio->low, 0.01)});
  std::vector<TableLine> lines;
  for (const auto& [cell, x, other] : all) {
    TableLine line = cellLine(model, *cell);
    line.cells[1].html = model.backendHtml(cell->id.backend) + " over " + model.backendHtml(other);
    line.cells.push_back({.html = withInterval(x->value, x->low, x->high), .value = x->value});
    line.cells.push_back(
        {.html = ratioMark(*x, most) + "<small>" + escaped(verdict(*cell, *x, other)) + "</small>",
         .value = x->value});
    lines.push_back(std::move(line));
  }
  return tableHtml("One backend's time over the other's, pairwise over interleaved blocks",
                   {{"Technique"},
                    {"Backends"},
                    {"Knobs"},
                    {"Ratio [95 %]", true, "below 1: the first is faster"},
                    {"Interval, from 1/" + figure(most) + " to " + figure(most)}},
                   lines, "bars");
}

}  // namespace report
