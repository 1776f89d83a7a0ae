#include "reports/json/json_figure.h"

#include <algorithm>

#include "reports/figures/cells.h"
#include "reports/figures/evaluate.h"

namespace report {
namespace {

Json sideToJson(const FigureSide& side) {
  return {{"cells", side.cells},
          {"measure", side.measure},
          {"at", side.at ? Json(*side.at) : Json(nullptr)}};
}

Json statementToJson(const Figure& figure, const FigureStatement& s, const Run& run) {
  const StatementResult result = evaluate(figure, s, run);
  Json out = {{"text", s.text}, {"of", s.of}, {"left", sideToJson(s.left)}};
  if (s.number)
    out["number"] = *s.number;
  else
    out["right"] = sideToJson(s.right);
  out["relation"] = s.relation;
  out["factor"] = s.factor;
  out["otherwise"] = s.otherwise;
  out["verdict"] = verdictName(result.verdict);
  out["found"] = result.found;
  out["why"] = result.why;
  return out;
}

FigureSide readSide(const Field& f) {
  FigureSide side{.cells = f.at("cells").text(), .measure = f.at("measure").text(), .at = {}};
  if (const auto at = f.find("at")) side.at = at->number();
  return side;
}

/// One of `known`.
std::string readWord(const Field& f, std::initializer_list<const char*> known) {
  const std::string word = f.text();
  std::string expected;
  for (const char* k : known) {
    if (word == k) return word;
    expected += (expected.empty() ? "" : ", ") + std::string(k);
  }
  f.refuse("one of " + expected);
}

FigureStatement readStatement(const Field& f) {
  FigureStatement s{.text = f.at("text").text(),
                    .of = readWord(f.at("of"), {"value", "slope", "intercept", "each"}),
                    .left = readSide(f.at("left")),
                    .right = {},
                    .number = {},
                    .relation = readWord(f.at("relation"), {"less", "more", "about"}),
                    .factor = f.at("factor").number(),
                    .otherwise = f.at("otherwise").text()};
  if (const auto number = f.find("number"))
    s.number = number->number();
  else
    s.right = readSide(f.at("right"));
  return s;
}

FigureKind readKind(const Field& f) {
  const std::string text = f.text();
  for (const FigureKind kind : kFigureKinds)
    if (text == figureKindName(kind)) return kind;
  f.refuse("a kind of figure");
}

}  // namespace

Json figureToJson(const Figure& figure, const Run& run) {
  Json out = {{"id", figure.id},
              {"title", figure.title},
              {"kind", figureKindName(figure.kind)},
              {"document", figure.document},
              {"x", figure.x},
              {"x_fallback", figure.xFallback},
              {"cells", Json::array()},
              {"cell_backends", Json::array()},
              {"missing", missingCells(figure, run)},
              {"stated", Json::array()},
              {"statements", Json::array()}};
  for (const auto& [name, backend] : figure.cells) {
    out["cells"].push_back(name);
    out["cell_backends"].push_back(backend);
  }
  for (const FigureStated& s : figure.stated)
    out["stated"].push_back({{"cells", s.cells},
                             {"passes", s.passes},
                             {"attachments", s.attachments},
                             {"bytes", s.bytes}});
  for (const FigureStatement& s : figure.statements)
    out["statements"].push_back(statementToJson(figure, s, run));
  return out;
}

Figure readFigure(const Field& f) {
  Figure figure{.id = f.at("id").text(),
                .title = f.at("title").text(),
                .kind = readKind(f.at("kind")),
                .cells = {},
                .x = f.at("x").text(),
                .xFallback = f.at("x_fallback").number(),
                .document = f.at("document").text(),
                .statements = {},
                .stated = {}};
  for (const Field& name : f.at("cells").items()) figure.cells.push_back({name.text(), ""});
  if (const auto backends = f.find("cell_backends")) {
    const auto all = backends->items();
    if (all.size() != figure.cells.size()) backends->refuse("one for each of the cells");
    for (size_t i = 0; i < all.size(); ++i) figure.cells[i].backend = all[i].text();
  }
  for (const Field& s : f.at("stated").items())
    figure.stated.push_back({.cells = s.at("cells").text(),
                             .passes = s.at("passes").text(),
                             .attachments = s.at("attachments").text(),
                             .bytes = s.at("bytes").text()});
  for (const Field& s : f.at("statements").items()) figure.statements.push_back(readStatement(s));
  return figure;
}

}  // namespace report
