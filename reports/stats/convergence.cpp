// Orders of convergence and rates of exchange: slopes of logarithms over logarithms, so that a
// power law is a straight line. Points without error have no logarithm and are left out. A series
// is cells that differ in one knob alone; with few points the intervals are wide, and say so.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "base/text.h"
#include "reports/stats/regression.h"
#include "reports/stats/tradeoff_parts.h"

namespace report {
namespace {

using Logs = std::vector<std::pair<double, double>>;

std::optional<double> positiveNumber(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(value) && value > 0 ? std::optional(value) : std::nullopt;
}

/// As in the name of a cell, but only knobs that vary.
std::string othersOf(const Record& r, const std::string& knob, const std::set<std::string>& vary) {
  std::string out;
  auto add = [&](const std::string& name, const std::string& value) {
    out += (out.empty() ? "" : "/") + name + ":" + value;
  };
  for (const auto& [name, value] : r.knobs)
    if (name != knob && vary.contains(name)) add(name, value);
  if (r.id.seed != 0) add("seed", std::to_string(r.id.seed));
  return out;
}

/// Knobs of which a technique's cells have several values.
std::set<std::string> varyingKnobs(const TradeOff& t, const std::string& technique) {
  std::map<std::string, std::set<std::string>> values;
  for (const TradePoint& p : t.points)
    if (p.technique == technique)
      for (const auto& [name, value] : p.record->knobs) values[name].insert(value);
  std::set<std::string> vary;
  for (const auto& [name, all] : values)
    if (all.size() > 1) vary.insert(name);
  return vary;
}

size_t distinctX(const Logs& logs) {
  std::set<double> values;
  for (const auto& [x, y] : logs) values.insert(x);
  return values.size();
}

/// Two digits, and no pretence of knowing what lies far outside.
std::string factorText(double factor) {
  if (factor > 1000) return "over 1000";
  if (factor < 0.01) return "under 0.01";
  return factor >= 9.95 ? fmt::format("{:.0f}", factor) : fmt::format("{:#.2g}", factor);
}

Exchange exchangeOf(const std::string& technique, const std::vector<const TradePoint*>& points) {
  Exchange e = {.technique = technique};
  size_t erring = 0;
  std::set<std::pair<double, double>> front;
  for (const TradePoint* p : points) {
    if (p->error <= 0) continue;
    ++erring;
    if (std::ranges::none_of(points, [&](const TradePoint* o) { return dominates(*o, *p); }))
      front.emplace(std::log(p->error), std::log(p->time));
  }
  if (erring == 0) {
    e.text = technique + ": no error to halve";
  } else if (erring < 3) {
    e.text = fmt::format("{}: no rate of exchange, {} with error; 3 are needed", technique,
                         base::counted(erring, "cell"));
  } else if (front.size() < 3) {
    e.text =
        fmt::format("{}: no rate of exchange, {} of {} with error on its own front; 3 are needed",
                    technique, front.size(), base::counted(erring, "cell"));
  } else {
    const Slope s = fitSlope(Logs(front.begin(), front.end()));
    e.factor = std::exp2(-s.value);
    e.text = fmt::format("{}: halving the error costs {} times the time ({}, {} to {})", technique,
                         factorText(*e.factor), base::counted(front.size(), "point"),
                         factorText(std::exp2(-s.interval.high)),
                         factorText(std::exp2(-s.interval.low)));
  }
  return e;
}

}  // namespace

void fitOrders(TradeOff& t) {
  for (const std::string& technique : t.techniques) {
    const std::set<std::string> vary = varyingKnobs(t, technique);
    // By quantity, knob and the rest; seeds are series of their own.
    std::map<std::tuple<std::string, std::string, std::string>, Logs> series;
    for (const TradePoint& p : t.points) {
      if (p.technique != technique) continue;
      const auto& noise = p.record->noise;
      for (const auto& [knob, text] : p.record->knobs) {
        const auto value = positiveNumber(text);
        if (!value) continue;
        const std::string others = othersOf(*p.record, knob, vary);
        if (p.error > 0)
          series[{"RMSE", knob, others}].emplace_back(std::log(*value), std::log(p.error));
        if (t.kind == ErrorKind::Visibility && noise && noise->noise > 0)
          series[{"noise", knob, others}].emplace_back(std::log(*value), std::log(noise->noise));
      }
    }
    for (const auto& [key, logs] : series) {
      if (distinctX(logs) < 3) continue;
      const Slope s = fitSlope(logs);
      t.orders.push_back({.technique = technique,
                          .of = std::get<0>(key),
                          .knob = std::get<1>(key),
                          .others = std::get<2>(key),
                          .order = -s.value,
                          .interval = {-s.interval.high, -s.interval.low},
                          .points = uint32_t(logs.size())});
    }
  }
}

void fitExchanges(TradeOff& t) {
  for (const std::string& technique : t.techniques) {
    std::vector<const TradePoint*> own;
    for (const TradePoint& p : t.points)
      if (p.technique == technique) own.push_back(&p);
    t.exchanges.push_back(exchangeOf(technique, own));
  }
}

}  // namespace report
