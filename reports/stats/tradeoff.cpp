// Which cells are compared with which, as points of (time, error), and the Pareto front among them.
// A cell is left out rather than guessed at: without a time, an error or an undisturbed run it is
// no point. Every pair of points is looked at: a run has hundreds, not millions.
#include "reports/stats/tradeoff.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "reports/record_view.h"
#include "reports/stats/tradeoff_parts.h"

namespace report {
namespace {

/// The tracer runs beside every backend: its time compares with any other CPU time.
bool isTracer(const Record& r) { return r.role == Role::Tracer; }

bool isBaseline(const Record& r) { return r.role == Role::Baseline; }

bool comparesCpu(const Record& r) { return r.deviceType == "software"; }

bool isTimed(const Record& r) {
  const std::optional<Distribution>& time = comparesCpu(r) ? r.cpu : r.frame;
  return r.status == Status::Ok && r.contamination.empty() && time && time->median > 0 &&
         std::isfinite(time->median);
}

double timeOf(const Record& r) { return (comparesCpu(r) ? r.cpu : r.frame)->median; }

std::optional<double> errorOf(const Record& r, ErrorKind kind) {
  std::optional<double> error;
  if (kind == ErrorKind::Visibility && r.visibility) error = r.visibility->all.rmse;
  if (kind == ErrorKind::Image && r.image) error = r.image->all.rmse;
  return error && std::isfinite(*error) ? error : std::nullopt;
}

Interval holding(double value, const Interval& interval) {
  return {std::min(value, interval.low), std::max(value, interval.high)};
}

TradePoint pointOf(const Record& r, ErrorKind kind) {
  TradePoint p;
  p.record = &r;
  p.technique = techniqueOf(r);
  p.bytes = r.bytes;
  p.time = timeOf(r);
  p.timeInterval = {p.time, p.time};
  std::vector<double> means;
  for (const Block& b : r.blocks) means.push_back(comparesCpu(r) ? b.cpuMs : b.frameMs);
  if (!means.empty()) p.timeInterval = holding(p.time, medianInterval(means));
  p.error = *errorOf(r, kind);
  p.weighted = p.error;
  if (kind == ErrorKind::Visibility) p.weighted = r.visibility->weighted.value_or(p.error);
  p.errorInterval = {p.error, p.error};
  if (kind == ErrorKind::Visibility && r.noise)
    p.errorInterval = holding(p.error, {r.noise->rmseLow, r.noise->rmseHigh});
  return p;
}

/// The ratio that is shown wins over a quotient of other cells' medians.
std::optional<double> timesBaseline(const Record& r, const std::optional<double>& baseline) {
  if (isBaseline(r)) return 1;
  for (const Ratio& ratio : r.ratios)
    if (ratio.kind == "baseline") return ratio.value;
  if (!baseline) return {};
  return timeOf(r) / *baseline;
}

bool sameScene(const Record& r, const TradeOff& t) {
  return std::tie(r.id.scene, r.id.width, r.id.height) == std::tie(t.scene, t.width, t.height);
}

bool belongs(const Record& r, const TradeOff& t) {
  if (!sameScene(r, t)) return false;
  if (isTracer(r) && comparesCpu(r) && t.timeKey == "cpu_ms") return true;
  return r.id.backend == t.backend && r.device == t.device;
}

/// One for each group that has a point, without its points.
std::vector<TradeOff> groups(const Run& run, ErrorKind kind) {
  std::vector<TradeOff> result;
  auto add = [&](const Record& r) {
    if (!isTimed(r) || !errorOf(r, kind)) return;
    if (std::ranges::any_of(result, [&](const TradeOff& t) { return belongs(r, t); })) return;
    TradeOff t;
    std::tie(t.scene, t.backend, t.device) = std::tie(r.id.scene, r.id.backend, r.device);
    std::tie(t.width, t.height, t.kind) = std::tie(r.id.width, r.id.height, kind);
    t.timeKey = comparesCpu(r) ? "cpu_ms" : "frame_ms";
    result.push_back(std::move(t));
  };
  // The tracer last: it stands alone only where it can join nobody.
  for (const Record& r : run.records)
    if (!isTracer(r)) add(r);
  for (const Record& r : run.records)
    if (isTracer(r)) add(r);
  return result;
}

void addPoints(TradeOff& t, const Run& run) {
  for (const Record& r : run.records) {
    if (!belongs(r, t) || !isTimed(r)) continue;
    if (isBaseline(r)) t.baseline = std::min(timeOf(r), t.baseline.value_or(timeOf(r)));
    if (!errorOf(r, t.kind)) continue;
    t.points.push_back(pointOf(r, t.kind));
  }
  for (TradePoint& p : t.points) {
    p.timesBaseline = timesBaseline(*p.record, t.baseline);
    if (std::ranges::find(t.techniques, p.technique) == t.techniques.end())
      t.techniques.push_back(p.technique);
  }
}

/// Are there values within the intervals of both at which `a` dominates `b`? The best of `a`
/// against the worst of `b` decides.
bool mayDominate(const TradePoint& a, const TradePoint& b) {
  const double time = b.timeInterval.high - a.timeInterval.low;
  const double error = b.errorInterval.high - a.errorInterval.low;
  // How the weighted error scatters is not known: it moves as the plain one does.
  const double scatter = (b.errorInterval.high - b.error) + (a.error - a.errorInterval.low);
  const double weighted = b.weighted - a.weighted + scatter;
  return time >= 0 && error >= 0 && weighted >= 0 && (time > 0 || error > 0 || weighted > 0);
}

}  // namespace

bool dominates(const TradePoint& a, const TradePoint& b) {
  return a.time <= b.time && a.error <= b.error && a.weighted <= b.weighted &&
         (a.time < b.time || a.error < b.error || a.weighted < b.weighted);
}

void markFront(std::vector<TradePoint>& points) {
  for (TradePoint& p : points) {
    p.front = std::ranges::none_of(points, [&](const TradePoint& o) { return dominates(o, p); });
    p.uncertain = p.front && std::ranges::any_of(points, [&](const TradePoint& o) {
                    return &o != &p && mayDominate(o, p);
                  });
  }
}

std::vector<TradeOff> tradeOffs(const Run& run, ErrorKind kind) {
  std::vector<TradeOff> result = groups(run, kind);
  for (TradeOff& t : result) {
    addPoints(t, run);
    markFront(t.points);
    fillTables(t);
    fitOrders(t);
    fitExchanges(t);
  }
  return result;
}

}  // namespace report
