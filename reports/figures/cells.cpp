#include "reports/figures/cells.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "base/pattern.h"
#include "reports/figures/measure.h"
#include "reports/record_view.h"

namespace report {
namespace {

/// Why a cell gives no value to a side; "" when it does.
std::string whyLacking(const std::string& name, const FigureSide& side, const Run& run) {
  const auto found = std::ranges::find(run.records, name, &Record::name);
  if (found == run.records.end()) return name + " is not in this run";
  if (found->status != Status::Ok)
    return name + ": " + std::string(statusName(found->status)) + ", " + found->reason;
  if (measured(*found, side.measure)) return "";
  if (isTime(side.measure) && !found->contamination.empty())
    return name + " is contaminated: " + found->contamination.front();
  const std::string why = whyOf(*found, side.measure);
  return name + " has no " + measureTitle(side.measure) + (why.empty() ? "" : ": " + why);
}

}  // namespace

bool matchesRegex(const std::string& regex, const std::string& name) {
  try {
    return base::Pattern::regex(regex).found(name);
  } catch (const std::invalid_argument&) {
    return false;  // of a file from elsewhere: nothing matches
  }
}

std::vector<const Record*> recordsOf(const Figure& figure, const Run& run) {
  std::set<std::string> names;
  for (const FigureCell& cell : figure.cells) names.insert(cell.name);
  std::vector<const Record*> out;
  for (const Record& r : run.records)
    if (names.contains(r.name)) out.push_back(&r);
  return out;
}

std::vector<std::string> missingCells(const Figure& figure, const Run& run) {
  std::vector<std::string> out;
  for (const auto& [name, backend] : figure.cells) {
    const auto found = std::ranges::find(run.records, name, &Record::name);
    if (found == run.records.end())
      out.push_back(name + ": not in this run");
    else if (found->status != Status::Ok)
      out.push_back(name + ": " + std::string(statusName(found->status)) + ", " + found->reason);
  }
  return out;
}

std::vector<std::string> backendsOf(const std::vector<const Record*>& records) {
  std::vector<std::string> out;
  for (const Record* r : records)
    if (!std::ranges::count(out, r->id.backend)) out.push_back(r->id.backend);
  return out;
}

std::string whyLacking(const Figure& figure, const FigureStatement& s, const Run& run) {
  std::vector<std::string> backends = backendsOf(recordsOf(figure, run));
  backends.emplace_back();  // any
  for (const std::string& wanted : backends)
    for (const FigureSide* side : {&s.left, &s.right}) {
      if (side == &s.right && s.number) break;
      const std::string& cells = side->cells.empty() ? s.left.cells : side->cells;
      for (const auto& [name, backend] : figure.cells) {
        if (!wanted.empty() && !backend.empty() && backend != wanted) continue;
        if (!matchesRegex(cells, name)) continue;
        if (std::string why = whyLacking(name, *side, run); !why.empty()) return why;
      }
    }
  return "the cells have too few values";
}

}  // namespace report
