#include "suites/harness/measuring/protocol.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "reports/stats/stats.h"

namespace sb {

bool WarmUp::add(double windowMs) {
  if (m_windows > 0)
    m_steady = std::abs(windowMs - m_previous) <= 0.2 * std::max(windowMs, m_previous) + 0.05;
  m_previous = windowMs;
  ++m_windows;
  return m_steady || m_windows >= kMaxWindows;
}

std::vector<size_t> roundOrder(size_t cells, uint32_t round) {
  std::vector<size_t> order(cells);
  std::iota(order.begin(), order.end(), size_t(0));
  if (round % 2) std::ranges::reverse(order);
  return order;
}

Stop stopNow(const StopRule& rule, uint32_t blocks, double budgetShare,
             std::span<const double> halfWidths) {
  if (rule.repetitions > 0) return blocks >= rule.repetitions ? Stop::Repetitions : Stop::Not;
  if (blocks < rule.minBlocks) return Stop::Not;
  if (std::ranges::all_of(halfWidths, [&](double w) { return w <= rule.precision; }))
    return Stop::Precision;
  return budgetShare >= 1 ? Stop::Budget : Stop::Not;
}

double relativeHalfWidth(std::span<const double> samples) {
  if (samples.empty()) return 0;
  const report::Interval interval = report::medianInterval(samples);
  return (interval.high - interval.low) / (2 * std::max(1e-9, report::median(samples)));
}

}  // namespace sb
