// Across scenes, before any detail: what each technique gives for one and the same multiple of the
// time without shadows.
#include <algorithm>

#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

constexpr double kMultiple = 4;

/// The technique's best within the multiple; null when none is, or the backend has no such table.
const TradePoint* bestOf(const std::vector<const TradeOff*>& all, const std::string& technique,
                         const std::string& backend) {
  for (const TradeOff* t : all) {
    if (t->backend != backend) continue;
    for (const TableRow& row : t->equalTime)
      for (const TableCell& c : row.cells)
        if (row.limit == kMultiple && c.technique == technique) return c.point;
  }
  return nullptr;
}

std::string table(const PageModel& model, ErrorKind kind) {
  const bool visibility = kind == ErrorKind::Visibility;
  const std::string name = visibility ? "visibility" : "image";
  std::vector<TableColumn> columns = {{"Technique"}, {"Backend"}};
  for (const ScenePart& part : model.parts) columns.push_back({part.title(), true});
  std::vector<TableLine> lines;
  for (const std::string& technique : model.techniques)
    for (const std::string& backend : model.backends) {
      TableLine line{.technique = technique,
                     .backend = backend,
                     .cells = {{.html = model.techniqueHtml(technique)},
                               {.html = model.backendHtml(backend)}}};
      bool any = false;
      for (const ScenePart& part : model.parts) {
        const TradePoint* p = bestOf(visibility ? part.visibility : part.image, technique, backend);
        any |= p != nullptr;
        if (!p) {
          line.cells.push_back(absentEntry("no cell within this time"));
          continue;
        }
        const std::string variant = variantOf(p->record->id);
        line.cells.push_back({.html = figure(p->error) + "<small>" +
                                      escaped(variant.empty() ? "default" : variant) + " · " +
                                      figure(p->time) + " ms</small>",
                              .value = p->error});
      }
      if (any) lines.push_back(std::move(line));
    }
  if (lines.empty()) return "";
  return "<div data-kind=\"" + name + "\">\n" +
         tableHtml("Least " + name + " RMSE within " + figure(kMultiple) +
                       " times the time without shadows, each scene's own; other times stand with "
                       "the scenes",
                   columns, lines, "trade") +
         "</div>\n";
}

}  // namespace

std::string summaryHtml(const PageModel& model) {
  if (model.parts.size() < 2) return "";  // the scene's own table says it
  const std::string tables = table(model, ErrorKind::Visibility) + table(model, ErrorKind::Image);
  if (tables.empty()) return "";
  return "<section class=\"summary\" aria-labelledby=\"summary\">\n<h2 id=\"summary\">All "
         "scenes</h2>\n" +
         tables + "</section>\n";
}

}  // namespace report
