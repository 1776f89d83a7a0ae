// "What do I get for this time" and "what do I pay for this error": of every technique its best
// cell within each limit. Limits are the same in every report, so that tables of different runs
// compare; nothing is interpolated between cells, as a cell that nobody ran has no error.
#include <algorithm>
#include <tuple>

#include "reports/stats/tradeoff_parts.h"

namespace report {
namespace {

constexpr double kTimes[] = {1, 2, 4, 8, 16};
constexpr double kErrors[] = {1e-1, 3e-2, 1e-2, 3e-3};

/// The best of each technique's points within the limit.
TableRow row(const TradeOff& t, double limit, auto within, auto better) {
  TableRow result = {.limit = limit};
  for (const std::string& technique : t.techniques) {
    TableCell cell = {.technique = technique};
    for (const TradePoint& p : t.points)
      if (p.technique == technique && within(p) && (!cell.point || better(p, *cell.point)))
        cell.point = &p;
    result.cells.push_back(std::move(cell));
  }
  return result;
}

}  // namespace

void fillTables(TradeOff& t) {
  // What is equal in the one is decided by the other.
  auto moreExact = [](const TradePoint& a, const TradePoint& b) {
    return std::tie(a.error, a.time) < std::tie(b.error, b.time);
  };
  auto faster = [](const TradePoint& a, const TradePoint& b) {
    return std::tie(a.time, a.error) < std::tie(b.time, b.error);
  };
  if (t.baseline)
    for (double limit : kTimes)
      t.equalTime.push_back(row(
          t, limit, [&](const TradePoint& p) { return p.timesBaseline.value_or(limit + 1) <= limit; },
          moreExact));
  for (double limit : kErrors)
    t.equalError.push_back(row(
        t, limit, [&](const TradePoint& p) { return p.error <= limit; }, faster));
}

}  // namespace report
