// Regions of receivers on which a stochastic technique must pass light with a known probability, and
// the trials it made there (spec 16; exact binomial test).
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
  uint64_t trials = 0;  ///< a channel
};

/// Regions of at least 64 pixels in one light's layer; of each, at most 64 pixels are tried.
std::vector<TrialRegion> trialRegions(const Tracer& tracer, Values truth,
                                      std::span<const uint8_t> edges, rhi::Extent2D size,
                                      uint32_t light, uint32_t layer, const LookupReach& reach);
/// Adds one seed's answers.
void countTrials(TrialRegion& region, Values answers, uint32_t trialsPerLookup);
report::Certificate certificateOf(const std::vector<TrialRegion>& regions, rhi::Extent2D size);

}  // namespace sb
