#include "reports/console/console_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/console/console_table.h"
#include "reports/figures/cells.h"
#include "reports/figures/evaluate.h"
#include "reports/figures/table.h"
#include "reports/record_view.h"

namespace report {
namespace {

/// Columns of words (passes by label) are for the page and the JSON alone.
std::string tableText(const Figure& figure, const Run& run) {
  const FigureTable table = tableOf(figure, run);
  if (table.rows.empty()) return "";
  std::vector<std::vector<std::string>> rows = {{""}};
  for (const FigureColumn& c : table.columns)
    if (c.number) rows[0].push_back(c.title);
  for (const FigureRow& row : table.rows) {
    const Record& r = *row.record;
    rows.push_back(
        {techniqueOf(r) + "/" + r.id.backend + (row.label.empty() ? "" : " " + row.label)});
    for (size_t i = 0; i < row.entries.size(); ++i)
      if (table.columns[i].number) rows.back().push_back(row.entries[i].text);
  }
  return "  " + table.caption + ":\n" + alignedTable(rows, 1, "  ");
}

std::string statementText(const Figure& figure, const FigureStatement& s, const Run& run) {
  const StatementResult result = evaluate(figure, s, run);
  std::string out = fmt::format("  {:<15} {}\n", verdictName(result.verdict), s.text);
  if (!result.found.empty()) out += fmt::format("  {:<15}   {}\n", "", result.found);
  if (!result.why.empty()) out += fmt::format("  {:<15}   because {}\n", "", result.why);
  return out;
}

std::string missingText(const Figure& figure, const Run& run) {
  constexpr size_t kShown = 3;
  const auto missing = missingCells(figure, run);
  std::string out;
  for (size_t i = 0; i < std::min(kShown, missing.size()); ++i)
    out += "  missing: " + missing[i] + "\n";
  if (missing.size() > kShown)
    out += fmt::format("  missing: {} more cells\n", missing.size() - kShown);
  return out;
}

}  // namespace

std::string figuresText(const Run& run) {
  std::string out;
  for (const Figure& f : run.figures) {
    out +=
        fmt::format("\nFigure {}: {}\n", f.id, f.title) + tableText(f, run) + missingText(f, run);
    for (const FigureStatement& s : f.statements) out += statementText(f, s, run);
  }
  return out;
}

}  // namespace report
