#include "reports/figures/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/figures/cells.h"
#include "reports/figures/measure.h"
#include "reports/stats/regression.h"

namespace report {
namespace {

using Records = std::vector<const Record*>;

enum class Outcome : uint8_t { Holds, Fails, Undecided };

/// `factor` times less, more, or within: decided only where the intervals leave no doubt.
/// `orEqual`: what is exact and equal is less and more as well.
Outcome compare(const Measured& left, const std::string& relation, double factor,
                const Measured& right, bool orEqual) {
  if (relation == "about") {
    const double high = std::max(left.value, right.value), low = std::min(left.value, right.value);
    return high <= low * factor ? Outcome::Holds : Outcome::Fails;
  }
  const bool less = relation == "less";
  const Measured &small = less ? left : right, &large = less ? right : left;
  const double half = std::hypot(factor * small.halfWidth, large.halfWidth);
  const double gap = large.value - factor * small.value;
  if (half == 0) return gap > 0 || (gap == 0 && orEqual) ? Outcome::Holds : Outcome::Fails;
  return gap > half ? Outcome::Holds : gap < -half ? Outcome::Fails : Outcome::Undecided;
}

Records sideRecords(const Figure& figure, const FigureSide& side, const std::string& backend,
                    const Records& all) {
  Records out;
  for (const Record* r : all)
    if (r->id.backend == backend && matchesRegex(side.cells, r->name) &&
        (!side.at || xOf(figure, *r) == *side.at))
      out.push_back(r);
  return out;
}

std::optional<Measured> valueOf(const Figure& figure, const std::string& of,
                                const std::string& measure, const Records& records) {
  std::vector<std::pair<double, double>> points;
  double sum = 0, squares = 0;
  for (const Record* r : records)
    if (const auto m = measured(*r, measure)) {
      points.emplace_back(xOf(figure, *r), m->value);
      sum += m->value;
      squares += m->halfWidth * m->halfWidth;
    }
  // A mean over some of the cells would be another quantity.
  if (points.empty() || points.size() != records.size()) return {};
  if (of == "value") {
    const double n = double(points.size());
    return Measured{sum / n, std::sqrt(squares) / n};
  }
  const auto fit = fitLine(points);
  if (!fit) return {};
  return of == "slope" ? Measured{fit->slope, fit->slopeHalf} : Measured{fit->intercept, 0};
}

/// Are all the side's cells there? Means over different cells could not be compared.
bool isWhole(const Figure& figure, const FigureSide& side, const std::string& backend,
             const Records& found) {
  if (side.at) return !found.empty();  // names do not say every cell's x
  const auto expected = std::ranges::count_if(figure.cells, [&](const FigureCell& cell) {
    return (cell.backend == backend || cell.backend.empty()) && matchesRegex(side.cells, cell.name);
  });
  return std::ssize(found) == expected;
}

std::string sign(const std::string& relation, Outcome outcome) {
  if (outcome == Outcome::Undecided) return "?";
  if (relation == "about") return outcome == Outcome::Holds ? "≈" : "≠";
  return (relation == "less") == (outcome == Outcome::Holds) ? "<" : ">";
}

std::string withHalf(const Measured& m) {
  return shortNumber(m.value) + (m.halfWidth > 0 ? " ± " + shortNumber(m.halfWidth) : "");
}

/// What stands before the figures: "slope of time, ms, per quads".
std::string subject(const Figure& figure, const FigureStatement& s) {
  std::string out = measureTitle(s.left.measure);
  if (!s.number && s.right.measure != s.left.measure)
    out += " against " + measureTitle(s.right.measure);
  if (s.of == "slope") out = "slope of " + out + ", over " + figure.x;
  if (s.of == "intercept") out += ", at " + figure.x + " = 0";
  if (s.left.at) out += fmt::format(", at {} = {:g}", figure.x, *s.left.at);
  if (s.right.at && s.right.at != s.left.at)
    out += fmt::format(" against {} = {:g}", figure.x, *s.right.at);
  if (s.factor != 1)
    out += fmt::format(" ({}{:g} times)", s.relation == "about" ? "within " : "", s.factor);
  return out;
}

struct Found {
  std::optional<Outcome> outcome;
  std::string text;
};

/// Every cell for itself: the first that fails speaks.
Found evaluateEach(const FigureStatement& s, const Records& records) {
  Found found;
  size_t cells = 0;
  for (const Record* r : records) {
    const auto left = measured(*r, s.left.measure);
    const auto right =
        s.number ? std::optional(Measured{*s.number, 0}) : measured(*r, s.right.measure);
    if (!left || !right) return {};
    ++cells;
    // Within one cell both come from the same frames.
    const Outcome outcome =
        compare({left->value, 0}, s.relation, s.factor, {right->value, 0}, true);
    if (found.outcome && (*found.outcome == Outcome::Fails || outcome == Outcome::Holds)) continue;
    found = {outcome, outcome == Outcome::Holds
                          ? ""
                          : r->name + ": " + shortNumber(left->value) + " " +
                                sign(s.relation, outcome) + " " + shortNumber(right->value)};
  }
  if (found.outcome == Outcome::Holds)
    found.text = fmt::format("holds in {} cell{}", cells, cells == 1 ? "" : "s");
  return found;
}

Found evaluateOn(const Figure& figure, const FigureStatement& s, const std::string& backend,
                 const Records& all) {
  const Records leftCells = sideRecords(figure, s.left, backend, all);
  if (leftCells.empty()) return {};
  if (s.of == "each") return evaluateEach(s, leftCells);
  FigureSide rightSide = s.right;
  if (rightSide.cells.empty()) rightSide.cells = s.left.cells;
  const Records rightCells = sideRecords(figure, rightSide, backend, all);
  if (!isWhole(figure, s.left, backend, leftCells) ||
      (!s.number && !isWhole(figure, rightSide, backend, rightCells)))
    return {};
  const auto left = valueOf(figure, s.of, s.left.measure, leftCells);
  const auto right = s.number ? std::optional(Measured{*s.number, 0})
                              : valueOf(figure, s.of, s.right.measure, rightCells);
  if (!left || !right) return {};
  const Outcome outcome = compare(*left, s.relation, s.factor, *right, s.number.has_value());
  return {outcome, withHalf(*left) + " " + sign(s.relation, outcome) + " " + withHalf(*right)};
}

}  // namespace

std::string_view verdictName(FigureVerdict verdict) {
  switch (verdict) {
    case FigureVerdict::Reproduced:
      return "reproduced";
    case FigureVerdict::NotReproduced:
      return "NOT reproduced";
    case FigureVerdict::Undecided:
      return "undecided";
    case FigureVerdict::NotMeasured:
      return "not measured";
  }
  return "";
}

StatementResult evaluate(const Figure& figure, const FigureStatement& s, const Run& run) {
  const Records all = recordsOf(figure, run);
  std::string found;
  bool fails = false, undecided = false, any = false;
  for (const std::string& backend : backendsOf(all)) {
    const Found on = evaluateOn(figure, s, backend, all);
    if (!on.outcome) continue;
    any = true;
    fails |= *on.outcome == Outcome::Fails;
    undecided |= *on.outcome == Outcome::Undecided;
    found += (found.empty() ? "" : "; ") + on.text + " (" + backend + ")";
  }
  if (!any) return {.why = whyLacking(figure, s, run)};
  StatementResult result{.found = subject(figure, s) + ": " + found, .why = ""};
  result.verdict = fails       ? FigureVerdict::NotReproduced
                   : undecided ? FigureVerdict::Undecided
                               : FigureVerdict::Reproduced;
  if (fails) result.why = s.otherwise;
  if (result.verdict == FigureVerdict::Undecided)
    result.why = "the 95 % intervals overlap; a larger --budget narrows them";
  return result;
}

std::optional<LineFit> fitLine(const std::vector<std::pair<double, double>>& points) {
  std::set<double> xs;
  double x = 0, y = 0;
  for (const auto& p : points) xs.insert(p.first), x += p.first, y += p.second;
  if (xs.size() < 2) return {};
  x /= double(points.size()), y /= double(points.size());
  double xx = 0, xy = 0;
  for (const auto& p : points) {
    xx += (p.first - x) * (p.first - x);
    xy += (p.first - x) * (p.second - y);
  }
  LineFit fit{.slope = xy / xx};
  fit.intercept = y - fit.slope * x;
  if (points.size() > 2) {
    const Slope s = fitSlope(points);
    fit.slopeHalf = (s.interval.high - s.interval.low) / 2;
  }
  return fit;
}

std::string shortNumber(double value) {
  const double size = std::abs(value);
  if (size >= 999.5 && size < 1e10) return fmt::format("{:.0f}", value);
  return fmt::format("{:.3g}", value);
}

}  // namespace report
