// The rules of measuring, apart from clocks and devices: when a cell is warm, in which order the
// cells of a round run, and when a group has measured enough (design, section 6).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace sb {

/// Warm-up: windows of frames until two successive ones agree, at most ten.
class WarmUp {
 public:
  static constexpr int kWindowFrames = 3;
  static constexpr int kMaxWindows = 10;

  /// Median frame time of the next window, milliseconds. True when warm-up is over.
  bool add(double windowMs);
  /// Two successive windows agreed: within 20 %, or 0.05 ms, which is what clocks and wake-ups
  /// cost.
  bool steady() const { return m_steady; }
  int windows() const { return m_windows; }

 private:
  double m_previous = 0;
  int m_windows = 0;
  bool m_steady = false;
};

/// The least number of whole loops of `length` frames that has `frames` of them.
constexpr uint32_t wholeLoops(uint32_t frames, uint32_t length) {
  return (frames + length - 1) / length * length;
}

/// Order of the cells in a round: forth in even rounds, back in odd ones (A B B A ...), so that a
/// drift of the machine hits all alike.
std::vector<size_t> roundOrder(size_t cells, uint32_t round);

enum class Stop : uint8_t { Not, Precision, Budget, Repetitions };

struct StopRule {
  double precision = 0.05;   ///< half width of the median's 95 % interval / the median
  uint32_t minBlocks = 6;    ///< fewer have no interval
  uint32_t repetitions = 0;  ///< not 0: exactly so many blocks, whatever precision and budget say
};

/// After `blocks` rounds that spent `budgetShare` of the budget, the cells standing at
/// `halfWidths`.
Stop stopNow(const StopRule& rule, uint32_t blocks, double budgetShare,
             std::span<const double> halfWidths);

/// Half width of the 95 % interval of the median over the median; 0 for no samples.
double relativeHalfWidth(std::span<const double> samples);

}  // namespace sb
