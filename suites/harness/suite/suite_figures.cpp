#include "suites/harness/suite/suite_figures.h"

#include <algorithm>
#include <stdexcept>

#include "base/pattern.h"
#include "reports/figures/cells.h"
#include "reports/figures/measure.h"
#include "suites/harness/suite/suite.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

using Words = std::vector<std::string>;

std::string textOr(const SuiteReader& reader, const toml::table& table, const std::string& field,
                   const char* key, const std::string& fallback) {
  const auto* node = table.get(key);
  return node ? reader.text(*node, field + "." + key) : fallback;
}

std::string neededText(const SuiteReader& reader, const toml::table& table,
                       const std::string& field, const char* key) {
  return reader.text(reader.need(table, field, key), field + "." + key);
}

/// One of `known`.
std::string word(const SuiteReader& reader, const toml::node& node, const std::string& field,
                 const Words& known) {
  const std::string text = reader.text(node, field);
  if (std::ranges::find(known, text) == known.end())
    throw InputError(reader.at(node) + ": " + field, unknownName("value", text, known));
  return text;
}

std::string regex(const SuiteReader& reader, const toml::node& node, const std::string& field) {
  std::string text = reader.text(node, field);
  try {
    base::Pattern::regex(text);
  } catch (const std::invalid_argument& e) {
    throw InputError(reader.at(node) + ": " + field,
                     "'" + text + "' is no regular expression: " + e.what());
  }
  return text;
}

std::string measure(const SuiteReader& reader, const toml::node& node, const std::string& field) {
  const std::string text = reader.text(node, field);
  if (!report::isMeasure(text)) reader.fail(node, field, "a measure (reports/figures/measure.h)");
  return text;
}

std::optional<double> numberAt(const SuiteReader& reader, const toml::table& table,
                               const std::string& field, const char* key) {
  const auto* node = table.get(key);
  return node ? std::optional(reader.number(*node, field + "." + key, {})) : std::nullopt;
}

report::FigureStatement parseStatement(const SuiteReader& reader, const toml::node& node,
                                       const std::string& field) {
  const toml::table& t = reader.table(node, field);
  reader.requireKnown(t, field,
                      {"text", "of", "measure", "left", "right", "number", "right_measure", "at",
                       "left_at", "right_at", "relation", "factor", "otherwise"});
  report::FigureStatement s;
  s.text = neededText(reader, t, field, "text");
  if (const auto* n = t.get("of"))
    s.of = word(reader, *n, field + ".of", {"value", "slope", "intercept", "each"});
  s.left.measure = s.right.measure =
      measure(reader, reader.need(t, field, "measure"), field + ".measure");
  s.left.cells = regex(reader, reader.need(t, field, "left"), field + ".left");
  if (const auto* n = t.get("right")) s.right.cells = regex(reader, *n, field + ".right");
  if (const auto* n = t.get("right_measure"))
    s.right.measure = measure(reader, *n, field + ".right_measure");
  s.left.at = s.right.at = numberAt(reader, t, field, "at");
  if (const auto at = numberAt(reader, t, field, "left_at")) s.left.at = at;
  if (const auto at = numberAt(reader, t, field, "right_at")) s.right.at = at;
  s.number = numberAt(reader, t, field, "number");
  const bool right = t.get("right") || t.get("right_measure") || t.get("right_at");
  if (right == s.number.has_value())
    throw InputError(reader.at(node) + ": " + field,
                     right ? "has both a right side and a number" : "lacks right, or number");
  s.relation = word(reader, reader.need(t, field, "relation"), field + ".relation",
                    {"less", "more", "about"});
  if (const auto* n = t.get("factor")) s.factor = reader.number(*n, field + ".factor", {.low = 0, .above = true});
  s.otherwise = neededText(reader, t, field, "otherwise");
  return s;
}

report::FigureStated parseStated(const SuiteReader& reader, const toml::node& node,
                                 const std::string& field) {
  const toml::table& t = reader.table(node, field);
  reader.requireKnown(t, field, {"cells", "passes", "attachments", "bytes"});
  return {.cells = regex(reader, reader.need(t, field, "cells"), field + ".cells"),
          .passes = textOr(reader, t, field, "passes", ""),
          .attachments = textOr(reader, t, field, "attachments", ""),
          .bytes = textOr(reader, t, field, "bytes", "")};
}

using FigureCells = std::vector<report::FigureCell>;

FigureCells matching(const std::string& pattern, const std::vector<CellId>& cells) {
  FigureCells out;
  for (const CellId& id : cells)
    if (const std::string name = cellName(id); report::matchesRegex(pattern, name))
      out.push_back({name, id.backend});
  return out;
}

void requireMatch(const SuiteFigure& figure, const FigureCells& cells, const std::string& what,
                  const std::string& pattern) {
  if (std::ranges::none_of(cells, [&](const report::FigureCell& cell) {
        return report::matchesRegex(pattern, cell.name);
      }))
    throw InputError(figure.where, what + ": no cell of the figure matches '" + pattern + "'");
}

/// Default of a parameter of the scenes, or 0 for a knob, which every record names.
double fallbackOf(const SuiteFigure& figure, const std::vector<CellId>& cells) {
  const std::string& x = figure.figure.x;
  for (const CellId& id : cells) {
    if (!report::matchesRegex(figure.cells, cellName(id))) continue;
    const std::string base = id.scene.substr(0, id.scene.find_first_of(":?"));
    for (const SceneInfo& scene : proceduralScenes())
      for (const SceneParam& p : scene.params)
        if (scene.name == base && p.name == x) return p.fallback;
    if (cellKnobs(id).all().contains(x)) return 0;
  }
  throw InputError(figure.where, "x: '" + x + "' is no parameter of its scenes and no knob");
}

}  // namespace

SuiteFigure parseFigure(const SuiteReader& reader, const toml::node& node, size_t index) {
  const std::string field = "figure " + std::to_string(index + 1);
  const toml::table& t = reader.table(node, field);
  reader.requireKnown(t, field,
                      {"id", "title", "kind", "cells", "x", "document", "statement", "stated"});
  SuiteFigure out{.where = reader.at(node) + ": " + field, .cells = "", .figure = {}};
  report::Figure& figure = out.figure;
  figure.id = neededText(reader, t, field, "id");
  figure.title = neededText(reader, t, field, "title");
  figure.document = neededText(reader, t, field, "document");
  Words kinds;
  for (const report::FigureKind kind : report::kFigureKinds)
    kinds.emplace_back(report::figureKindName(kind));
  const std::string kind = word(reader, reader.need(t, field, "kind"), field + ".kind", kinds);
  figure.kind = report::kFigureKinds[size_t(std::ranges::find(kinds, kind) - kinds.begin())];
  if (const auto* n = t.get("cells")) out.cells = regex(reader, *n, field + ".cells");
  figure.x = figure.kind == report::FigureKind::Scaling ? neededText(reader, t, field, "x")
                                                        : textOr(reader, t, field, "x", "");
  reader.eachTable(t, field, "statement", [&](const toml::node& n, size_t i) {
    figure.statements.push_back(
        parseStatement(reader, n, field + ".statement " + std::to_string(i + 1)));
  });
  reader.eachTable(t, field, "stated", [&](const toml::node& n, size_t i) {
    figure.stated.push_back(parseStated(reader, n, field + ".stated " + std::to_string(i + 1)));
  });
  return out;
}

std::vector<report::Figure> suiteFigures(const Suite& suite, const Selection& over,
                                         const std::vector<std::string>& knownBackends,
                                         const std::vector<std::string>& defaultBackends) {
  Selection whole = over, everywhere = over;
  whole.filter = everywhere.filter = "";
  everywhere.backends = knownBackends;
  std::vector<report::Figure> out;
  for (const SuiteFigure& f : suite.figures) {
    const auto cells = suiteCells(suite, whole, knownBackends, defaultBackends);
    // A pattern may name a backend that this run leaves out.
    const FigureCells all =
        matching(f.cells, suiteCells(suite, everywhere, knownBackends, defaultBackends));
    requireMatch(f, all, "cells", f.cells);
    for (size_t i = 0; i < f.figure.statements.size(); ++i) {
      const std::string statement = "statement " + std::to_string(i + 1);
      requireMatch(f, all, statement + ".left", f.figure.statements[i].left.cells);
      requireMatch(f, all, statement + ".right", f.figure.statements[i].right.cells);
    }
    report::Figure figure = f.figure;
    figure.cells = matching(f.cells, cells);
    if (!figure.x.empty()) figure.xFallback = fallbackOf(f, cells);
    out.push_back(std::move(figure));
  }
  return out;
}

}  // namespace sb
