#include "reports/figures/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/figures/cells.h"
#include "reports/figures/evaluate.h"
#include "reports/figures/measure.h"
#include "reports/record_view.h"

namespace report {
namespace {

FigureEntry entryOf(const std::optional<double>& value) {
  return value ? FigureEntry{shortNumber(*value), value} : FigureEntry{"-", {}};
}

FigureEntry measureEntry(const Record& r, const std::string& measure) {
  const auto m = measured(r, measure);
  return entryOf(m ? std::optional(m->value) : std::nullopt);
}

/// The scene, where the figure's cells have several, and the knobs that are no defaults.
std::string labelOf(const Figure& figure, const Record& r, bool manyScenes) {
  // The figure's x, where it is a knob, is no part of a series' name.
  CellId others = r.id;
  std::erase_if(others.knobs, [&](const auto& knob) { return knob.first == figure.x; });
  const std::string knobs = variantOf(others);
  if (!manyScenes) return knobs;
  return sceneWithoutX(figure, r) + (knobs.empty() ? "" : " " + knobs);
}

bool hasManyScenes(const Figure& figure, const std::vector<const Record*>& records) {
  std::set<std::string> scenes;
  for (const Record* r : records) scenes.insert(sceneWithoutX(figure, *r));
  return scenes.size() > 1;
}

FigureTable scalingTable(const Figure& figure, const Run& run) {
  FigureTable table{
      .caption = "Line through each series: time at " + figure.x + " = 0, and what one more costs",
      .columns = {},
      .rows = {}};
  for (const char* measure : kScalingMeasures) {
    const std::string title = measureTitle(measure);
    table.columns.push_back({title + " at 0"});
    table.columns.push_back({"µs each"});
  }
  table.columns.push_back({"largest " + figure.x});
  table.columns.push_back({"time there, ms"});
  for (const FigureSeries& series : seriesOf(figure, run)) {
    FigureRow row{.record = series.records.front(), .label = series.label, .entries = {}};
    for (const char* measure : kScalingMeasures) {
      std::vector<std::pair<double, double>> points;
      for (const Record* r : series.records)
        if (const auto m = measured(*r, measure)) points.emplace_back(xOf(figure, *r), m->value);
      const auto fit = fitLine(points);
      row.entries.push_back(entryOf(fit ? std::optional(fit->intercept) : std::nullopt));
      FigureEntry slope = entryOf(fit ? std::optional(1e3 * fit->slope) : std::nullopt);
      if (fit && fit->slopeHalf > 0) slope.text += " ± " + shortNumber(1e3 * fit->slopeHalf);
      row.entries.push_back(std::move(slope));
    }
    row.entries.push_back(entryOf(xOf(figure, *series.records.back())));
    row.entries.push_back(measureEntry(*series.records.back(), "time"));
    table.rows.push_back(std::move(row));
  }
  return table;
}

FigureTable measureTable(const Figure& figure, const Run& run, const std::string& caption,
                         const std::vector<std::pair<std::string, std::string>>& columns) {
  FigureTable table{.caption = caption, .columns = {}, .rows = {}};
  for (const auto& [measure, title] : columns) table.columns.push_back({title});
  const auto records = recordsOf(figure, run);
  const bool manyScenes = hasManyScenes(figure, records);
  for (const Record* r : records) {
    if (r->status != Status::Ok) continue;
    FigureRow row{.record = r, .label = labelOf(figure, *r, manyScenes), .entries = {}};
    for (const auto& [measure, title] : columns) row.entries.push_back(measureEntry(*r, measure));
    table.rows.push_back(std::move(row));
  }
  return table;
}

FigureTable layersTable(const Figure& figure, const Run& run) {
  std::vector<std::pair<std::string, std::string>> columns = {{"layer:0", "opaque surface"}};
  std::set<uint32_t> layers;
  for (const Record* r : recordsOf(figure, run))
    for (const LayerError& l : r->visibilityLayers) layers.insert(l.layer);
  layers.erase(0);
  for (const uint32_t layer : layers)
    columns.emplace_back(fmt::format("layer:{}", layer),
                         fmt::format("layer {} from the eye", layer));
  columns.emplace_back("visibility", "all");
  columns.emplace_back("noise", "noise");
  columns.emplace_back("image", "image RMSE");
  return measureTable(figure, run, "RMSE of visibility by layer of surfaces", columns);
}

FigureTable regionsTable(const Figure& figure, const Run& run) {
  std::vector<std::pair<std::string, std::string>> columns;
  std::set<std::string> present;
  for (const Record* r : recordsOf(figure, run))
    for (const RegionError& e : r->visibilityRegions) present.insert(e.region);
  for (const char* region : {"dark", "saturated", "pale", "lit"}) {
    if (!present.contains(region)) continue;
    columns.emplace_back(std::string("region:") + region, region);
    columns.emplace_back(std::string("region_noise:") + region, std::string(region) + ", noise");
  }
  columns.emplace_back("visibility", "all, with edges");
  columns.emplace_back("flip", "FLIP");
  return measureTable(figure, run,
                      "RMSE and noise of visibility by what the truth is there, away from edges; "
                      "dark are the lead lines",
                      columns);
}

std::string passText(const Record& r) {
  std::string out;
  for (const PassRecord& p : r.passes)
    out += fmt::format("{}{}{}", out.empty() ? "" : ", ",
                       p.count > 1 ? fmt::format("{} x ", p.count) : "", p.label);
  return out;
}

std::string bytesText(const Record& r) {
  std::string out;
  for (const auto& [label, bytes] : r.bytesByLabel)
    out += fmt::format("{}{} {} KiB", out.empty() ? "" : ", ", label,
                       shortNumber(double(bytes) / 1024));
  return out;
}

FigureTable resourcesTable(const Figure& figure, const Run& run) {
  FigureTable table{.caption = "Resources of a frame: measured, and what the document states",
                    .columns = {{"passes"},
                                {"draws"},
                                {"MiB"},
                                {"measured passes", false},
                                {"stated passes", false},
                                {"measured allocations", false},
                                {"stated attachments and buffers", false}},
                    .rows = {}};
  for (const Record* r : recordsOf(figure, run)) {
    if (r->status != Status::Ok) continue;
    FigureStated stated{.cells = "", .passes = "-", .attachments = "-", .bytes = ""};
    for (const FigureStated& s : figure.stated)
      if (matchesRegex(s.cells, r->name)) stated = s;
    table.rows.push_back(
        {.record = r,
         .label = labelOf(figure, *r, false),
         .entries = {
             measureEntry(*r, "passes"),
             measureEntry(*r, "draws"),
             entryOf(double(r->bytes) / (1 << 20)),
             {passText(*r), {}},
             {stated.passes, {}},
             {bytesText(*r), {}},
             {stated.attachments + (stated.bytes.empty() ? "" : "; " + stated.bytes), {}}}});
  }
  return table;
}

}  // namespace

FigureTable tableOf(const Figure& figure, const Run& run) {
  switch (figure.kind) {
    case FigureKind::Scaling:
      return scalingTable(figure, run);
    case FigureKind::Layers:
      return layersTable(figure, run);
    case FigureKind::Regions:
      return regionsTable(figure, run);
    case FigureKind::Resources:
      return resourcesTable(figure, run);
    case FigureKind::Pictures:
      break;
  }
  return measureTable(figure, run, "Errors against the truth",
                      {{"visibility", "visibility RMSE"},
                       {"visibility_interior", "away from edges"},
                       {"image", "image RMSE"},
                       {"flip", "FLIP"},
                       {"noise", "noise"},
                       {"time", "time, ms"}});
}

std::vector<FigureSeries> seriesOf(const Figure& figure, const Run& run) {
  const auto records = recordsOf(figure, run);
  const bool manyScenes = hasManyScenes(figure, records);
  std::vector<FigureSeries> out;
  for (const Record* r : records) {
    if (r->status != Status::Ok) continue;
    const std::string label = labelOf(figure, *r, manyScenes);
    const auto same = std::ranges::find_if(out, [&](const FigureSeries& s) {
      const Record& first = *s.records.front();
      return s.label == label && techniqueOf(first) == techniqueOf(*r) &&
             first.id.backend == r->id.backend && first.id.width == r->id.width &&
             first.id.height == r->id.height;
    });
    if (same == out.end())
      out.push_back({label, {r}});
    else
      same->records.push_back(r);
  }
  for (FigureSeries& s : out)
    std::ranges::stable_sort(s.records, {}, [&](const Record* r) { return xOf(figure, *r); });
  return out;
}

}  // namespace report
