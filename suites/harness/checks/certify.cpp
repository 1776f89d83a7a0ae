#include "suites/harness/checks/certify.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "suites/metrics/certificate.h"

namespace sb {
namespace {

constexpr uint32_t kLeastPixels = 64;
/// Pixels of a region that are tried: few where regions are many, as each costs 25 rays.
constexpr size_t kLeastTried = 64, kMostTried = 512, kTriedInLayer = 4096;
/// Lookups whose coordinates differ by less share texels (Tracer::mapCoordinates).
constexpr double kApart = 2;

bool overlaps(const glm::dvec3& a, const glm::dvec3& b) {
  return a.z == b.z && std::abs(a.x - b.x) < kApart && std::abs(a.y - b.y) < kApart;
}

/// Of a region's pixels in scattered order, those whose lookups are independent and uniform; at
/// most `wanted`.
void choosePixels(const Tracer& tracer, const std::vector<uint32_t>& pixels, uint32_t width,
                  const LookupReach& reach, size_t wanted, TrialRegion& region) {
  std::vector<glm::dvec3> taken;
  // A stride that shares no factor with the count visits all, far apart first.
  size_t stride = size_t(double(pixels.size()) * 0.618) | 1;
  while (std::gcd(stride, pixels.size()) != 1) stride += 2;
  const size_t most = std::min<size_t>(pixels.size(), 16 * wanted);
  for (size_t n = 0, i = 0; n < most && region.pixels.size() < wanted;
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
  const auto uniform = uniformRegions(truth, edges, size.width, size.height, kLeastPixels);
  const size_t wanted = std::clamp(kTriedInLayer / std::max<size_t>(1, uniform.size()),
                                   kLeastTried, kMostTried);
  for (const auto& pixels : uniform) {
    TrialRegion region{.light = light, .layer = layer, .size = pixels.size()};
    choosePixels(tracer, pixels, size.width, reach, wanted, region);
    if (!region.pixels.empty()) regions.push_back(std::move(region));
  }
  return regions;
}

void addSeed(TrialRegion& region, Values answers, uint32_t trialsPerLookup) {
  double sums[3] = {};
  size_t pixels = 0;
  for (const uint32_t pixel : region.pixels) {
    const float* v = answers.data() + 4 * size_t(pixel);
    if (v[3] != 1) continue;  // the rasteriser shows no surface there
    ++pixels;
    for (int c = 0; c < 3; ++c) {
      sums[c] += double(v[c]);
      region.passes[c] += uint64_t(std::lround(double(v[c]) * trialsPerLookup));
    }
    region.trials += trialsPerLookup;
  }
  for (int c = 0; c < 3 && pixels > 0; ++c) region.means[c].push_back(sums[c] / double(pixels));
}

report::Certificate certificateOf(const std::vector<TrialRegion>& regions, rhi::Extent2D size) {
  report::Certificate certificate;
  const bool draws = std::ranges::all_of(regions, [](const TrialRegion& r) { return r.trials > 0; });
  certificate.test = draws ? "binomial" : "mean";
  for (const TrialRegion& r : regions)
    for (uint32_t c = 0; c < 3; ++c) {
      report::RegionTest test{.light = r.light,
                              .layer = r.layer,
                              .channel = c,
                              .x = r.pixels.front() % size.width,
                              .y = r.pixels.front() / size.width,
                              .pixels = r.size,
                              .q = std::clamp(r.q[int(c)], 0.0, 1.0)};
      if (draws)
        testDraws(test, r.passes[c], r.trials);
      else
        testMeans(test, r.means[c]);
      certificate.regions.push_back(test);
    }
  judge(certificate);
  return certificate;
}

}  // namespace sb
