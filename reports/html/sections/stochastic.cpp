// Noise and certificates of stochastic techniques.
#include <fmt/format.h>

#include <algorithm>

#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

const char* channelName(uint32_t channel) {
  static constexpr const char* kNames[] = {"red", "green", "blue"};
  return channel < 3 ? kNames[channel] : "?";
}

/// The regions nearest to refusal, worst first.
std::string worstRegions(const Certificate& c) {
  constexpr size_t kShown = 5;
  std::vector<RegionTest> sorted = c.regions;
  std::ranges::stable_sort(sorted, {}, &RegionTest::pValue);
  std::string out = "<details><summary>regions of least p</summary><ul>";
  for (size_t i = 0; i < std::min(kShown, sorted.size()); ++i) {
    const RegionTest& t = sorted[i];
    out += fmt::format(
        "<li>light {}, layer {}, {}, at ({}, {}), {} px: truth {}, found {} ± {} over {} {}, p = "
        "{}</li>",
        t.light, t.layer, channelName(t.channel), t.x, t.y, t.pixels, figure(t.q), figure(t.mean),
        figure(1.96 * t.error), t.trials, c.test == "binomial" ? "draws" : "seeds",
        figure(t.pValue));
  }
  return out + "</ul></details>";
}

TableEntry verdict(const Record& r) {
  if (!r.certificate) return absentEntry(whyOf(r, "certificate"));
  const Certificate& c = *r.certificate;
  const double level = c.familyWiseError / double(std::max<size_t>(c.regions.size(), 1));
  const auto refused = size_t(
      std::ranges::count_if(c.regions, [&](const RegionTest& t) { return t.pValue < level; }));
  std::string html = !c.unbiased  ? "<strong>undecided</strong>: " + escaped(c.why)
                     : *c.unbiased ? "<strong class=\"good\">unbiased</strong>"
                                   : "<strong class=\"bad\">biased</strong>";
  html += ": " + std::to_string(c.informative) + " informative of " + counted(c.regions.size(), "region", "regions") + " tested, " +
          std::to_string(refused) + " refused, <span class=\"unbroken\">family-wise error " +
          figure(c.familyWiseError) + "</span>";
  return {.html = html + worstRegions(c), .value = double(refused)};
}

}  // namespace

std::string stochasticTable(const PageModel& model, const ScenePart& part) {
  std::vector<TableLine> lines;
  for (size_t index : part.cells) {
    const Record& r = model.run.records[index];
    if (!r.noise && !r.certificate) continue;
    TableLine line = cellLine(model, r);
    const auto add = [&](const auto& entry) {
      line.cells.push_back(r.noise ? entry(*r.noise) : absentEntry(whyOf(r, "noise")));
    };
    add([](const NoiseRecord& n) { return numberEntry(double(n.seeds)); });
    add([](const NoiseRecord& n) { return numberEntry(n.noise); });
    add([](const NoiseRecord& n) { return numberEntry(n.biasRmse); });
    add([](const NoiseRecord& n) { return numberEntry(n.bias); });
    add([](const NoiseRecord& n) {
      return TableEntry{figure(n.rmseLow) + " to " + figure(n.rmseHigh), n.rmseLow};
    });
    line.cells.push_back(verdict(r));
    lines.push_back(std::move(line));
  }
  if (lines.empty()) return "";
  std::vector<TableColumn> columns = cellColumns();
  columns.insert(columns.end(), {{"Seeds", true},
                                 {"Noise", true, "root of the mean variance over seeds"},
                                 {"RMSE of the mean", true, "what more samples would not remove"},
                                 {"Bias of the mean", true},
                                 {"RMSE of one seed [95 %]", true},
                                 {"Is it unbiased?", false,
                                  "exact binomial tests of regions with one expectation"}});
  return tableHtml("Stochastic techniques over seeds, and whether their mean is the truth", columns,
                   lines, "prose");
}

}  // namespace report
