// Every part of a block is a table of its own, aligned for itself: techniques and cells are few,
// and columns shared between parts would be as wide as the widest.
#include "reports/console/console_tradeoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "reports/console/console_table.h"

namespace report {
namespace {

/// Rows may end early.
using Row = std::vector<std::string>;

std::string milliseconds(double ms) { return fmt::format("{:.2f}", ms); }

/// Errors span decades: three digits, wherever they lie.
std::string rmse(double error) { return fmt::format("{:.3g}", error); }

std::string interval(const Interval& i, auto text) {
  return i.low < i.high ? fmt::format("[{},{}]", text(i.low), text(i.high)) : "none";
}

std::string timeName(const TradeOff& t) { return t.timeKey == "cpu_ms" ? "CPU ms" : "frame ms"; }

std::string heading(const TradeOff& t) {
  std::string out =
      fmt::format("{} {}x{}, {}: {}\n", t.scene, t.width, t.height, t.backend, t.device);
  out += fmt::format("  RMSE of {} against {}",
                     t.kind == ErrorKind::Visibility ? "visibility" : "the image", timeName(t));
  return out + (t.baseline ? fmt::format("; without shadows {}\n", milliseconds(*t.baseline))
                           : "; not measured without shadows\n");
}

std::string points(const TradeOff& t) {
  std::vector<const TradePoint*> sorted;
  for (const TradePoint& p : t.points) sorted.push_back(&p);
  std::ranges::stable_sort(sorted, [](const TradePoint* a, const TradePoint* b) {
    return std::tie(a->time, a->error) < std::tie(b->time, b->error);
  });
  std::vector<Row> rows = {{"cell", timeName(t), "[95 %]", "RMSE", "[95 %]", "MiB"}};
  for (const TradePoint* p : sorted)
    rows.push_back({p->record->name, milliseconds(p->time), interval(p->timeInterval, milliseconds),
                    rmse(p->error), interval(p->errorInterval, rmse),
                    fmt::format("{:.1f}", double(p->bytes) / (1 << 20)),
                    // The space keeps the words below each other.
                    p->uncertain ? "front?" : (p->front ? "front " : "")});
  return alignedTable(rows, 1, "  ");
}

/// One line a technique, one column a limit.
std::string limits(const std::string& title, const std::vector<std::string>& techniques,
                   const std::vector<TableRow>& table, auto limitText, auto cellText) {
  if (table.empty()) return "";
  std::vector<Row> rows = {{title}};
  for (const TableRow& r : table) rows.front().push_back(limitText(r.limit));
  for (size_t i = 0; i < techniques.size(); ++i) {
    rows.push_back({techniques[i]});
    for (const TableRow& r : table) {
      const TradePoint* p = r.cells[i].point;
      rows.back().push_back(p ? cellText(*p) : "-");
    }
  }
  return "\n" + alignedTable(rows, 1, "  ");
}

/// Without "-0.00".
std::string hundredths(double v) { return fmt::format("{:.2f}", std::round(v * 100) / 100 + 0.0); }

std::string orders(const TradeOff& t) {
  if (t.orders.empty()) return "";
  std::vector<Row> rows = {
      {"error ~ knob^-order", "of", "knob", "at", "order", "[95 %]", "points"}};
  for (const Convergence& c : t.orders)
    rows.push_back({c.technique, c.of, c.knob, c.others.empty() ? "-" : c.others,
                    hundredths(c.order), interval(c.interval, hundredths),
                    fmt::format("{}", c.points)});
  return "\n" + alignedTable(rows, 4, "  ");
}

std::string block(const TradeOff& t) {
  std::string out = heading(t) + points(t);
  out += limits(
      "least RMSE within", t.techniques, t.equalTime,
      [](double limit) { return fmt::format("{:g} x none", limit); },
      [](const TradePoint& p) { return rmse(p.error); });
  out += limits(
      "least " + timeName(t) + " at RMSE", t.techniques, t.equalError,
      [](double limit) { return fmt::format("<= {:g}", limit); },
      [](const TradePoint& p) { return milliseconds(p.time); });
  out += orders(t);
  out += "\n";
  for (const Exchange& e : t.exchanges) out += "  " + e.text + "\n";
  return out;
}

}  // namespace

std::string toTable(const std::vector<TradeOff>& tradeOffs) {
  if (tradeOffs.empty()) return "";
  std::string out;
  bool uncertain = false;
  for (const TradeOff& t : tradeOffs) {
    out += block(t) + "\n";
    for (const TradePoint& p : t.points) uncertain = uncertain || p.uncertain;
  }
  out += "front: no other cell here is as fast and as exact, and better in one.\n";
  if (uncertain) out += "front?: within the 95 % intervals of both, another may be.\n";
  return out;
}

}  // namespace report
