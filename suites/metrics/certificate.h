// Whether a stochastic technique is unbiased, as far as statistics can tell (spec 16): tests of
// regions with one known expectation, at one family-wise error over all of them. That no bias was
// found says something only where one would have been found.
#pragma once

#include <cstdint>
#include <span>

#include "reports/error_record.h"

namespace sb {

/// Two-sided exact binomial p-value of `passes` in `trials` at probability `q`: the sum of the
/// probabilities of all outcomes no likelier than the one seen. q = 0 and q = 1 allow one outcome.
double binomialPValue(uint64_t passes, uint64_t trials, double q);

/// Tests `passes` of `trials` draws against `test.q`: fills trials, passes, mean, error and pValue.
void testDraws(report::RegionTest& test, uint64_t passes, uint64_t trials);

/// Tests means of a region, one a seed, against `test.q`: fills trials, mean, error and pValue. By
/// Student's t, for which seeds must be independent and whatever lies within a seed need not be.
/// Where all seeds agree, an expectation of 0 or 1 is met or missed, and others are not tested;
/// means that take few values (rare events, whose distribution is skewed) are not tested either.
void testMeans(report::RegionTest& test, std::span<const double> means);

/// Fills `informative`, `unbiased` and `why` from the regions: Bonferroni over all of them.
void judge(report::Certificate& certificate);

}  // namespace sb
