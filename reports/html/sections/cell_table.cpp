// All cells of a scene in one table: what the plot shows, and what it cannot.
#include <fmt/format.h>

#include <algorithm>

#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

/// The interval below its value keeps columns narrow.
TableEntry over(double value, double low, double high) {
  return {.html = figure(value) + "<small>[" + figure(low) + ", " + figure(high) + "]</small>",
          .value = value};
}

TableEntry timeEntry(const ScenePart& part, const Record& r, const TradePoint* point) {
  const auto& time = comparedTime(r);
  if (timeKeyOf(r) != part.timeKey)
    return absentEntry("a reference: its time is another kind of time");
  if (!time) return absentEntry(whyOf(r, timeKeyOf(r)));
  if (!point) return numberEntry(time->median);
  return over(point->time, point->timeInterval.low, point->timeInterval.high);
}

TableEntry baselineEntry(const Record& r) {
  for (const Ratio& x : r.ratios)
    if (x.kind == "baseline") return over(x.value, x.low, x.high);
  return absentEntry(whyOf(r, "ratios"));
}

TableEntry errorEntry(const std::optional<double>& error, const TradePoint* point,
                      const std::string& why) {
  if (!error) return absentEntry(why);
  if (!point || point->errorInterval.low >= point->errorInterval.high) return numberEntry(error);
  return over(*error, point->errorInterval.low, point->errorInterval.high);
}

TableEntry oneSidedEntry(const std::optional<VisibilityError>& error, const std::string& why) {
  if (!error) return absentEntry(why);
  return {.html = std::to_string(error->oneSidedInterior) + "<small>" +
                  std::to_string(error->oneSided - error->oneSidedInterior) + " at edges</small>",
          .value = double(error->oneSidedInterior)};
}

std::string frontText(const TradePoint* point) {
  if (!point || !point->front) return "–";
  return point->uncertain ? "perhaps" : "yes";
}

TableEntry frontEntry(const TradePoint* visibility, const TradePoint* image) {
  return {.html =
              "<span data-kind=\"visibility\">" + frontText(visibility) +
              "</span><span class=\"no-script\"> visibility, </span><span data-kind=\"image\">" +
              frontText(image) + "</span><span class=\"no-script\"> image</span>"};
}

TableEntry stateEntry(const Record& r) {
  if (r.status != Status::Ok) return textEntry(std::string(statusName(r.status)) + ": " + r.reason);
  std::string out = !r.stable ? "ok" : *r.stable ? "stable" : "changes between runs";
  if (r.crossBackendMax255) out += fmt::format(", {}/255 to other API", *r.crossBackendMax255);
  if (r.crossBackendOver1.value_or(0) > 0) out += fmt::format(" on {} px", *r.crossBackendOver1);
  for (const std::string& c : r.contamination) out += "; contaminated: " + c;
  if (r.stoppedBy == "budget") out += "; stopped by the budget";
  return textEntry(out);
}

}  // namespace

const TradePoint* pointOf(const std::vector<const TradeOff*>& tradeOffs, const Record& record) {
  for (const TradeOff* t : tradeOffs)
    for (const TradePoint& p : t->points)
      if (p.record == &record) return &p;
  return nullptr;
}

std::vector<TableColumn> cellColumns() { return {{"Technique"}, {"Backend"}, {"Knobs"}}; }

TableLine cellLine(const PageModel& model, const Record& r) {
  const std::string variant = variantOf(r.id);
  return {.technique = techniqueOf(r),
          .backend = r.id.backend,
          .cells = {{.html = model.techniqueHtml(techniqueOf(r))},
                    {.html = model.backendHtml(r.id.backend)},
                    textEntry(variant.empty() ? "default" : variant)},
          .muted = r.status != Status::Ok};
}

std::string cellTable(const PageModel& model, const ScenePart& part) {
  std::vector<TableColumn> columns = cellColumns();
  columns.insert(
      columns.end(),
      {{part.timeKey == "cpu_ms" ? "CPU ms" : "Frame ms", true,
        part.timeName() + ", median and its 95 % interval"},
       {"±", true, "half width of the 95 % interval of the median"},
       {"× none", true, "time over that of the same cell without shadows"},
       {"Visibility RMSE", true, "against the ray-traced truth, over all lights and layers"},
       {"By light", true,
        "RMSE of visibility, each pixel weighed by the light that it would reflect unshadowed"},
       {"Bias", true, "mean signed error of the visibility: positive is too light"},
       {"99.9 %", true, "99.9th percentile over pixels of the visibility's largest absolute error"},
       {"One-sided px", true,
        "pixels, over lights and layers, that show a surface to the technique or to the truth alone "
        "and so are in no error: away from edges, where there should be none, and at edges"},
       {"Image RMSE", true, "of linear radiance"},
       {"FLIP", true, "mean LDR-FLIP of the tone-mapped pictures, 0 to 1"},
       {"MiB", true, "memory that this cell alone keeps on the device"},
       {"On the front", false,
        "no other cell is as fast and as exact by both errors, and better in one"},
       {"State"}});
  std::vector<TableLine> lines;
  for (size_t index : part.cells) {
    const Record& r = model.run.records[index];
    TableLine line = cellLine(model, r);
    if (r.status != Status::Ok) {
      line.cells.resize(columns.size() - 1, {.html = "–"});
      line.cells.push_back(stateEntry(r));
      lines.push_back(std::move(line));
      continue;
    }
    const TradePoint* visibility = pointOf(part.visibility, r);
    const TradePoint* image = pointOf(part.image, r);
    const auto v = [&](double ErrorStats::*m) {
      return r.visibility ? std::optional(r.visibility->all.*m) : std::nullopt;
    };
    const std::string why = whyOf(r, "visibility"), whyImage = whyOf(r, "image");
    const auto& i = r.image;
    const TableEntry more[] = {
        timeEntry(part, r, visibility ? visibility : image),
        r.precision ? TableEntry{percent(*r.precision), *r.precision}
                    : absentEntry(whyOf(r, "precision")),
        baselineEntry(r),
        errorEntry(v(&ErrorStats::rmse), visibility, why),
        errorEntry(r.visibility ? r.visibility->weighted : std::nullopt, nullptr, why),
        errorEntry(v(&ErrorStats::bias), nullptr, why),
        errorEntry(v(&ErrorStats::p999), nullptr, why),
        oneSidedEntry(r.visibility, why),
        errorEntry(i ? std::optional(i->all.rmse) : std::nullopt, image, whyImage),
        errorEntry(i ? std::optional(i->flip) : std::nullopt, nullptr, whyImage),
        {.html = mebibytes(r.bytes), .value = double(r.bytes)},
        frontEntry(visibility, image),
        stateEntry(r)};
    line.cells.insert(line.cells.end(), std::begin(more), std::end(more));
    lines.push_back(std::move(line));
  }
  return tableHtml("Figures of each cell of " + part.title() + ", 95 % intervals in brackets",
                   columns, lines, "cells");
}

}  // namespace report
