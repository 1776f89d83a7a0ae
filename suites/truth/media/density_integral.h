// Integrals of densities that are known at points alone.
#pragma once

#include <functional>
#include <vector>

namespace sb {

using Along = std::function<double(double)>;

/// Integral of `f` over pieces [ends[i], ends[i+1]] of each of which it is a cubic: exact.
double cubicPieces(const Along& f, const std::vector<double>& ends);

/// Integral of `f` by Simpson's rule, begun on the pieces between `ends` and halved until the sum
/// is within `tolerance`, or within `tolerance` times `scale` times the sum where that is more.
double adaptiveSimpson(const Along& f, const std::vector<double>& ends, double tolerance,
                       double scale);

}  // namespace sb
