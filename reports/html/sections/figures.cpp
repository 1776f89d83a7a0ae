// Figures of a document shown again: what it says, what was found, verdicts in words.
#include <algorithm>
#include <map>

#include "reports/figures/cells.h"
#include "reports/figures/evaluate.h"
#include "reports/figures/measure.h"
#include "reports/figures/table.h"
#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

std::string verdictHtml(FigureVerdict verdict) {
  const auto span = [&](const char* style, const char* mark) {
    return "<span class=\"verdict " + std::string(style) + "\"><span aria-hidden=\"true\">" + mark +
           "</span> " + std::string(verdictName(verdict)) + "</span>";
  };
  switch (verdict) {
    case FigureVerdict::Reproduced:
      return span("holds", "✓");
    case FigureVerdict::NotReproduced:
      return span("fails", "✕");
    case FigureVerdict::Undecided:
      return span("expected", "◇");
    case FigureVerdict::NotMeasured:
      break;
  }
  return span("unasked", "–");
}

std::string statements(const Figure& figure, const Run& run) {
  std::string out;
  for (const FigureStatement& s : figure.statements) {
    const StatementResult result = evaluate(figure, s, run);
    out += "<li>" + verdictHtml(result.verdict) + " " + escaped(s.text);
    if (!result.found.empty()) out += "<small>Found: " + escaped(result.found) + "</small>";
    if (!result.why.empty()) out += "<small class=\"why\">Why: " + escaped(result.why) + "</small>";
    out += "</li>\n";
  }
  return out.empty() ? "" : "<ul class=\"statements\">\n" + out + "</ul>\n";
}

std::string missing(const Figure& figure, const Run& run) {
  const auto names = missingCells(figure, run);
  if (names.empty()) return "";
  std::string out = "<div class=\"notice\">" + counted(names.size(), "cell is", "cells are") +
                    " missing of " + std::to_string(figure.cells.size()) +
                    " <details><summary>which</summary><ul>";
  for (const std::string& name : names) out += "<li><code>" + escaped(name) + "</code></li>";
  return out + "</ul></details></div>\n";
}

std::string table(const PageModel& model, const Figure& figure) {
  const FigureTable t = tableOf(figure, model.run);
  if (t.rows.empty()) return "";
  std::vector<TableColumn> columns = {{"Technique"}, {"Backend"}, {"Knobs"}};
  for (const FigureColumn& c : t.columns) columns.push_back({c.title, c.number});
  std::vector<TableLine> lines;
  for (const FigureRow& row : t.rows) {
    const std::string technique = techniqueOf(*row.record);
    TableLine line{
        .technique = technique,
        .backend = row.record->id.backend,
        .cells = {{.html = model.techniqueHtml(technique)},
                  {.html = model.backendHtml(row.record->id.backend)},
                  {.html = row.label.empty() ? "<small>default</small>" : escaped(row.label)}}};
    for (const FigureEntry& e : row.entries)
      line.cells.push_back({.html = e.text == "-" ? "–" : escaped(e.text), .value = e.value});
    lines.push_back(std::move(line));
  }
  return tableHtml(t.caption, columns, lines,
                   figure.kind == FigureKind::Resources ? "resources" : "");
}

/// A plot a measure: one line a technique, backend and label.
std::string plots(const Figure& figure, const Run& run, CurveSet& curves) {
  std::string out;
  const auto series = seriesOf(figure, run);
  std::map<std::string, size_t> lines;
  for (const FigureSeries& s : series)
    ++lines[techniqueOf(*s.records.front()) + "/" + s.records.front()->id.backend];
  const bool labels = std::ranges::any_of(lines, [](const auto& l) { return l.second > 1; });
  for (const char* measure : kScalingMeasures) {
    Curve curve{.xTitle = figure.x, .yTitle = measureTitle(measure), .lines = {}};
    for (const FigureSeries& s : series) {
      const Record& first = *s.records.front();
      CurveLine line{.technique = techniqueOf(first),
                     .backend = first.id.backend,
                     .label = labels ? (s.label.empty() ? "default" : s.label) : "",
                     .points = {}};
      for (const Record* r : s.records)
        if (const auto m = measured(*r, measure))
          line.points.push_back({xOf(figure, *r), m->value});
      if (!line.points.empty()) curve.lines.push_back(std::move(line));
    }
    if (!curve.lines.empty())
      out += curves.html(std::move(curve), "<strong>" + escaped(measureTitle(measure)) +
                                               "</strong> over " + escaped(figure.x));
  }
  return out.empty() ? "" : "<div class=\"curves\">\n" + out + "</div>\n";
}

std::string pictureHtml(const std::string& picture, const std::string& caption) {
  return "<figure>" + picture + "<figcaption>" + caption + "</figcaption></figure>\n";
}

/// Picture, truth and error of each cell; backends with the very same picture share a card.
std::string cards(const PageModel& model, const Figure& figure, PictureSet& pictures) {
  std::vector<std::vector<const Record*>> groups;
  for (const Record* r : recordsOf(figure, model.run)) {
    if (!r->pictures.contains("image")) continue;
    const auto same = std::ranges::find_if(groups, [&](const auto& g) {
      return g.front()->pictures == r->pictures && techniqueOf(*g.front()) == techniqueOf(*r) &&
             variantOf(g.front()->id) == variantOf(r->id) && g.front()->id.scene == r->id.scene;
    });
    if (same == groups.end())
      groups.push_back({r});
    else
      same->push_back(r);
  }
  std::string out;
  for (const auto& group : groups) {
    const Record& r = *group.front();
    std::string backends, variant = variantOf(r.id);
    Json names = Json::array();
    for (const Record* other : group) {
      backends += " " + model.backendHtml(other->id.backend);
      names.push_back(other->id.backend);
    }
    out += "<article class=\"card\"" + filterAttributes(techniqueOf(r), "") + " data-backends=\"" +
           escaped(names.dump(-1, ' ', true, Json::error_handler_t::replace)) + "\" data-cell=\"" +
           std::to_string(model.indexOf(r)) + "\">\n<h4>" + model.techniqueHtml(techniqueOf(r)) +
           backends + " <small>" + escaped(r.id.scene + (variant.empty() ? "" : " " + variant)) +
           "</small></h4>\n<div class=\"pictures\">\n" +
           pictureHtml(pictures.html(r, "image", "Picture of " + r.name),
                       r.image ? "image, RMSE " + report::figure(r.image->all.rmse) : "image") +
           pictureHtml(pictures.html(r, "truth", "Truth of " + r.id.scene), "truth, ray-traced") +
           pictureHtml(pictures.html(r, "error", "Error map of " + r.name),
                       r.visibility
                           ? "error, visibility RMSE " + report::figure(r.visibility->all.rmse)
                           : "error") +
           "</div>\n</article>\n";
  }
  return out.empty() ? "" : "<div class=\"gallery\">\n" + out + "</div>\n";
}

std::string figureHtml(const PageModel& model, const Figure& figure, size_t index,
                       PictureSet& pictures, CurveSet& curves) {
  const std::string id = "figure" + std::to_string(index);
  std::string out = "<section class=\"figure-of\" id=\"" + id + "\" aria-labelledby=\"" + id +
                    "-title\">\n<h2 id=\"" + id + "-title\"><small>" + escaped(figure.id) +
                    "</small> " + escaped(figure.title) +
                    "</h2>\n<p class=\"document\"><em>The "
                    "document:</em> " +
                    escaped(figure.document) + "</p>\n" + statements(figure, model.run) +
                    missing(figure, model.run);
  if (figure.kind == FigureKind::Scaling) out += plots(figure, model.run, curves);
  out += table(model, figure);
  if (figure.kind != FigureKind::Scaling && figure.kind != FigureKind::Resources)
    out += cards(model, figure, pictures);
  return out + "</section>\n";
}

}  // namespace

std::string figuresHtml(const PageModel& model, PictureSet& pictures, CurveSet& curves) {
  std::string out;
  for (size_t i = 0; i < model.run.figures.size(); ++i)
    out += figureHtml(model, model.run.figures[i], i, pictures, curves);
  return out;
}

}  // namespace report
