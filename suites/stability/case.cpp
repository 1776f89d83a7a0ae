#include "suites/stability/case.h"

#include <cmath>

namespace sb {

const std::vector<StabilityCase>& stabilityCases() {
  static const std::vector<StabilityCase> cases = [] {
    std::vector<StabilityCase> all;
    for (const auto& part :
         {genericCases(), opaqueCases(), concaveCases(), translucentCases(), boundaryCases(),
          volumeCases(), wedgeCases(), wedgeSweepCases(), transparencyCases(), tortureCases()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return cases;
}

double fourSigma(double q, double n) { return 4 * std::sqrt(q * (1 - q) / n); }

std::string missing(const CaseContext& context, Effect effect) {
  return context.represents(effect) ? "" : context.info().error;
}

}  // namespace sb
