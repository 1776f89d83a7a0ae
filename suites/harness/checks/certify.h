// Regions of receivers on which a stochastic technique must pass light with a known probability, and
// what it did there (spec 16): draws for the exact binomial test where a lookup averages equal
// trials, means over seeds elsewhere.
#pragma once

#include <vector>

#include "reports/error_record.h"
#include "suites/harness/judge.h"

namespace sb {

/// Pixels of one light and layer whose lookups share no texel and meet no shadow edge, with equal
/// truth.
struct TrialRegion {
  uint32_t light = 0, layer = 0;
  uint64_t size = 0;             ///< pixels of the whole region
  std::vector<uint32_t> pixels;  ///< indices, row 0 at the bottom
  glm::dvec3 q = glm::dvec3(0);
  uint64_t passes[3] = {0, 0, 0};
  uint64_t trials = 0;           ///< a channel
  std::vector<double> means[3];  ///< one a seed
};

/// Regions of at least 64 pixels in one light's layer; of each, at most 512 pixels are tried.
std::vector<TrialRegion> trialRegions(const Tracer& tracer, Values truth,
                                      std::span<const uint8_t> edges, rhi::Extent2D size,
                                      uint32_t light, uint32_t layer, const LookupReach& reach);
/// Adds one seed's answers. `trialsPerLookup`: equal yes-or-no draws that a lookup averages; 0: it
/// does not, and only means count.
void addSeed(TrialRegion& region, Values answers, uint32_t trialsPerLookup);
/// By the exact test where there were trials, by means over seeds elsewhere.
report::Certificate certificateOf(const std::vector<TrialRegion>& regions, rhi::Extent2D size);

}  // namespace sb
