// What a time buys and what an error costs, as tables.
#include <algorithm>

#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

std::vector<std::string> techniquesOf(const std::vector<const TradeOff*>& all) {
  std::vector<std::string> out;
  for (const TradeOff* t : all)
    for (const std::string& name : t->techniques)
      if (!std::ranges::count(out, name)) out.push_back(name);
  return out;
}

const TradePoint* pointFor(const TableRow& row, const std::string& technique) {
  for (const TableCell& c : row.cells)
    if (c.technique == technique) return c.point;
  return nullptr;
}

/// One table for all backends of the scene. `value` is what is best when small, `other` what comes
/// with it.
std::string limitTable(const PageModel& model, const std::vector<const TradeOff*>& all,
                       const std::string& caption, const std::string& first,
                       std::vector<TableRow> TradeOff::*rows, double TradePoint::*value,
                       double TradePoint::*other, const char* otherBefore, const char* otherAfter,
                       std::string (*limit)(const TradeOff&, double)) {
  const auto techniques = techniquesOf(all);
  std::vector<TableColumn> columns = {{first}, {"Backend"}};
  for (const std::string& t : techniques) columns.push_back({t, true, "", t});
  std::vector<TableLine> lines;
  for (const TradeOff* t : all)
    for (const TableRow& row : t->*rows) {
      TableLine line{.backend = t->backend,
                     .cells = {{.html = limit(*t, row.limit), .value = row.limit},
                               {.html = model.backendHtml(t->backend)}}};
      const TradePoint* best = nullptr;
      for (const TableCell& c : row.cells)
        if (c.point && (!best || c.point->*value < best->*value)) best = c.point;
      for (const std::string& name : techniques) {
        const TradePoint* p = pointFor(row, name);
        if (!p) {
          line.cells.push_back({.html = "–", .technique = name});
          continue;
        }
        const std::string text = figure(p->*value), variant = variantOf(p->record->id);
        line.cells.push_back(
            {.html = (p->*value <= best->*value ? "<strong>" + text + "</strong>" : text) +
                     "<small>" + escaped(variant.empty() ? "default" : variant) + " · " +
                     otherBefore + figure(p->*other) + otherAfter + "</small>",
             .value = p->*value,
             .technique = name});
      }
      lines.push_back(std::move(line));
    }
  return lines.empty() ? "" : tableHtml(caption, columns, lines, "trade");
}

std::string timeLimit(const TradeOff& t, double limit) {
  return figure(limit) + " × none<small>" + figure(limit * t.baseline.value_or(0)) + " ms</small>";
}

std::string errorLimit(const TradeOff&, double limit) { return "RMSE " + figure(limit); }

/// The knobs of a series; lines may break between them.
std::string othersHtml(const std::string& others) {
  std::string out;
  for (const char c : others) out += c == '/' ? ", " : escaped(std::string(1, c));
  return "<small>" + (out.empty() ? "default" : out) + "</small>";
}

std::string orders(const PageModel& model, const std::vector<const TradeOff*>& all) {
  std::vector<TableLine> lines;
  for (const TradeOff* t : all)
    for (const Convergence& c : t->orders)
      lines.push_back({.technique = c.technique,
                       .backend = t->backend,
                       .cells = {{.html = model.techniqueHtml(c.technique)},
                                 {.html = model.backendHtml(t->backend)},
                                 textEntry(c.of),
                                 textEntry(c.knob),
                                 {.html = withInterval(c.order, c.interval.low, c.interval.high),
                                  .value = c.order},
                                 numberEntry(double(c.points)),
                                 {.html = othersHtml(c.others)}}});
  if (lines.empty()) return "";
  return tableHtml("Order of convergence: error or noise falls with knob to the power of minus this",
                   {{"Technique"},
                    {"Backend"},
                    {"Of"},
                    {"Knob"},
                    {"Order [95 %]", true, "1: twice the knob, half the error"},
                    {"Cells", true},
                    {"Where"}},
                   lines, "wide");
}

std::string exchanges(const PageModel& model, const std::vector<const TradeOff*>& all) {
  std::vector<TableLine> lines;
  for (const TradeOff* t : all)
    for (const Exchange& e : t->exchanges)
      lines.push_back({.technique = e.technique,
                       .backend = t->backend,
                       .cells = {{.html = model.techniqueHtml(e.technique)},
                                 {.html = model.backendHtml(t->backend)},
                                 {.html = escaped(e.text), .value = e.factor}},
                       .muted = !e.factor});
  if (lines.empty()) return "";
  return tableHtml("What less error costs, along each technique's own front",
                   {{"Technique"}, {"Backend"}, {"Exchange"}}, lines, "prose");
}

}  // namespace

std::string tradeTables(const PageModel& model, const ScenePart& part, ErrorKind kind) {
  const bool visibility = kind == ErrorKind::Visibility;
  const auto& all = visibility ? part.visibility : part.image;
  const std::string name = visibility ? "visibility RMSE" : "image RMSE";
  const std::string tables =
      limitTable(model, all, "Equal time: least " + name + " within a time", "Within",
                 &TradeOff::equalTime, &TradePoint::error, &TradePoint::time, "", " ms",
                 timeLimit) +
      limitTable(model, all, "Equal error: least time in ms within a " + name, "At most",
                 &TradeOff::equalError, &TradePoint::time, &TradePoint::error, "RMSE ", "",
                 errorLimit) +
      exchanges(model, all) + orders(model, all);
  if (tables.empty()) return "";
  return "<div class=\"pair\" data-kind=\"" + std::string(visibility ? "visibility" : "image") +
         "\">\n" + tables + "</div>\n";
}

}  // namespace report
