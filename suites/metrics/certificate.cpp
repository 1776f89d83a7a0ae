#include "suites/metrics/certificate.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <set>
#include <stdexcept>

namespace sb {
namespace {

double logBinomial(uint64_t k, uint64_t n, double q) {
  const double x = double(k), m = double(n);
  return std::lgamma(m + 1) - std::lgamma(x + 1) - std::lgamma(m - x + 1) + x * std::log(q) +
         (m - x) * std::log1p(-q);
}

/// Sum of the probabilities from `k` outward, away from the mode: up (k, k+1, ...) or down.
double tail(uint64_t k, uint64_t n, double q, bool up) {
  double term = std::exp(logBinomial(k, n, q)), sum = 0;
  const double odds = q / (1 - q);
  while (term > 0) {
    sum += term;
    if (term < sum * 1e-17) break;
    if (up) {
      if (k == n) break;
      term *= double(n - k) / double(k + 1) * odds;
      ++k;
    } else {
      if (k == 0) break;
      term *= double(k) / double(n - k + 1) / odds;
      --k;
    }
  }
  return sum;
}

}  // namespace

double binomialPValue(uint64_t passes, uint64_t trials, double q) {
  if (passes > trials || !(q >= 0 && q <= 1)) throw std::invalid_argument("no such binomial");
  if (trials == 0) return 1;
  if (q == 0) return passes == 0 ? 1 : 0;
  if (q == 1) return passes == trials ? 1 : 0;
  const uint64_t mode = std::min(trials, uint64_t(double(trials + 1) * q));
  // Outcomes within rounding of the one seen are as likely as it.
  const double seen = logBinomial(passes, trials, q) + 1e-7;
  if (logBinomial(mode, trials, q) <= seen) return 1;
  const bool upper = passes > mode;
  // The nearest outcome on the other side that is no likelier: probabilities fall from the mode.
  uint64_t likelier = mode, end = upper ? 0 : trials;
  double p = tail(passes, trials, q, upper);
  if (logBinomial(end, trials, q) > seen) return p;
  while (likelier > end + 1 || end > likelier + 1) {
    const uint64_t middle = upper ? end + (likelier - end) / 2 : likelier + (end - likelier) / 2;
    (logBinomial(middle, trials, q) > seen ? likelier : end) = middle;
  }
  p += tail(end, trials, q, !upper);
  return std::min(1.0, p);
}

namespace {

constexpr double kPower = 0.99;
/// Rounding of an average of up to a thousand weighted floats.
constexpr double kRounding = 1e-5;

bool isCertain(double q) { return q <= 0 || q >= 1; }

/// Half widths of the acceptance region and of where a bias shows with the wanted power, in standard
/// errors of the mean.
template <class Distribution>
double reach(const Distribution& distribution, double level) {
  return boost::math::quantile(boost::math::complement(distribution, level / 2)) +
         boost::math::quantile(distribution, kPower);
}

/// Would a bias of `detectable` have been found in this region?
bool isInformative(const report::RegionTest& t, const report::Certificate& c, double level) {
  if (isCertain(t.q) || t.error <= 0 || t.trials < 2) return false;
  const double errors = c.test == "binomial"
                            ? reach(boost::math::normal(), level)
                            : reach(boost::math::students_t(double(t.trials - 1)), level);
  return errors * t.error <= c.detectable;
}

std::string whyUndecided(const report::Certificate& c) {
  if (c.regions.empty())
    return "no region of the picture has one known expectation as wide as a lookup";
  if (std::ranges::all_of(c.regions, [](const report::RegionTest& t) { return isCertain(t.q); }))
    return "every tested region is fully lit or fully dark: chance decides in none";
  return "too few draws: a bias of 1 % would be missed too often (more seeds, a larger picture)";
}

}  // namespace

void testDraws(report::RegionTest& test, uint64_t passes, uint64_t trials) {
  test.trials = trials;
  test.passes = passes;
  test.mean = trials ? double(passes) / double(trials) : 0;
  test.error = trials ? std::sqrt(test.q * (1 - test.q) / double(trials)) : 0;
  test.pValue = binomialPValue(passes, trials, test.q);
}

void testMeans(report::RegionTest& test, std::span<const double> means) {
  const double n = double(means.size());
  test.trials = means.size();
  test.pValue = 1;
  if (means.empty()) return;
  double sum = 0, squares = 0;
  for (const double m : means) sum += m;
  test.mean = sum / n;
  for (const double m : means) squares += (m - test.mean) * (m - test.mean);
  const double off = std::max(0.0, std::abs(test.mean - test.q) - kRounding);
  const bool same = squares <= n * kRounding * kRounding;
  if (same && isCertain(test.q)) test.pValue = off > 0 ? 0 : 1;
  const std::set<double> values(means.begin(), means.end());
  if (same || values.size() < std::max<size_t>(5, means.size() / 4)) return;
  test.error = std::sqrt(squares / (n * (n - 1)));
  test.pValue = 2 * boost::math::cdf(boost::math::complement(boost::math::students_t(n - 1),
                                                             off / test.error));
}

void judge(report::Certificate& c) {
  const double level = c.familyWiseError / double(std::max<size_t>(1, c.regions.size()));
  c.informative = uint32_t(std::ranges::count_if(
      c.regions, [&](const report::RegionTest& t) { return isInformative(t, c, level); }));
  c.unbiased.reset();
  c.why.clear();
  if (std::ranges::any_of(c.regions, [&](const report::RegionTest& t) { return t.pValue < level; }))
    c.unbiased = false;
  else if (c.informative > 0)
    c.unbiased = true;
  else
    c.why = whyUndecided(c);
}

}  // namespace sb
