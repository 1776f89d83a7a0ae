// The worst of several errors, when an error may be no number.
#pragma once

#include <cmath>
#include <concepts>

namespace base {

/// The larger of two errors; NaN if either is, where std::max would keep the other and let what is
/// no number pass for no error.
template <std::floating_point T>
T worse(T a, T b) {
  return a >= b || std::isnan(a) ? a : b;
}

}  // namespace base
