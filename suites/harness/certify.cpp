#include "suites/harness/certify.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sb {
namespace {

constexpr uint32_t kLeastPixels = 64;
constexpr size_t kMostTried = 64;
/// Lookups whose coordinates differ by less share texels (Tracer::mapCoordinates).
constexpr double kApart = 2;

bool overlaps(const glm::dvec3& a, const glm::dvec3& b) {
  return a.z == b.z && std::abs(a.x - b.x) < kApart && std::abs(a.y - b.y) < kApart;
}

/// Of a region's pixels in scattered order, those whose lookups are independent and uniform.
void choosePixels(const Tracer& tracer, const std::vector<uint32_t>& pixels, uint32_t width,
                  const LookupReach& reach, TrialRegion& region) {
  std::vector<glm::dvec3> taken;
  // A stride that shares no factor with the count visits all, far apart first.
  size_t stride = size_t(double(pixels.size()) * 0.618) | 1;
  while (std::gcd(stride, pixels.size()) != 1) stride += 2;
  const size_t most = std::min<size_t>(pixels.size(), 16 * kMostTried);
  for (size_t n = 0, i = 0; n < most && region.pixels.size() < kMostTried;
       ++n, i = (i + stride) % pixels.size()) {
    const auto point = tracer.pointAt(pixels[i] % width, pixels[i] / width, region.layer);
    if (!point) continue;
    const glm::dvec3 at = tracer.mapCoordinates(region.light, *point, reach);
    if (std::ranges::any_of(taken, [&](const glm::dvec3& t) { return overlaps(t, at); })) continue;
    const Tracer::Range range = tracer.visibilityNear(region.light, *point, reach);
    if (glm::any(glm::greaterThan(range.high - range.low, glm::dvec3(1e-6)))) continue;
    if (region.pixels.empty()) region.q = tracer.visibility(region.light, *point);
    taken.push_back(at);
    region.pixels.push_back(pixels[i]);
  }
}

}  // namespace

std::vector<TrialRegion> trialRegions(const Tracer& tracer, Values truth,
                                      std::span<const uint8_t> edges, rhi::Extent2D size,
                                      uint32_t light, uint32_t layer, const LookupReach& reach) {
  std::vector<TrialRegion> regions;
  for (const auto& pixels : uniformRegions(truth, edges, size.width, size.height, kLeastPixels)) {
    TrialRegion region{.light = light, .layer = layer, .size = pixels.size()};
    choosePixels(tracer, pixels, size.width, reach, region);
    if (!region.pixels.empty()) regions.push_back(std::move(region));
  }
  return regions;
}

void countTrials(TrialRegion& region, Values answers, uint32_t trialsPerLookup) {
  for (const uint32_t pixel : region.pixels) {
    const float* v = answers.data() + 4 * size_t(pixel);
    if (v[3] != 1) continue;  // the rasteriser shows no surface there
    for (int c = 0; c < 3; ++c)
      region.passes[c] += uint64_t(std::lround(double(v[c]) * trialsPerLookup));
    region.trials += trialsPerLookup;
  }
}

report::Certificate certificateOf(const std::vector<TrialRegion>& regions, rhi::Extent2D size) {
  report::Certificate certificate;
  for (const TrialRegion& r : regions)
    for (uint32_t c = 0; c < 3; ++c) {
      const double q = std::clamp(r.q[int(c)], 0.0, 1.0);
      certificate.regions.push_back({.light = r.light,
                                     .layer = r.layer,
                                     .channel = c,
                                     .x = r.pixels.front() % size.width,
                                     .y = r.pixels.front() / size.width,
                                     .pixels = r.size,
                                     .q = q,
                                     .trials = r.trials,
                                     .passes = r.passes[c],
                                     .pValue = binomialPValue(r.passes[c], r.trials, q)});
    }
  judge(certificate);
  return certificate;
}

}  // namespace sb
