// Stochastic transparency (spec 15, D): basic is right in expectation, corrected is exact for one
// layer; opaque and absent layers; the order of the source plays no part.
#include <bit>
#include <cmath>

#include "suites/scenes/edit/transform.h"
#include "tests/techniques/transparency_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

const std::string kName = "StochasticTransparency";

CellOptions stochastic(const char* samples, const char* mode, rhi::Extent2D size = {16, 16}) {
  return transparent(kName, {{"samples", samples}, {"mode", mode}}, size);
}

/// Mean colour over the picture and over `seeds` frames, and the variance of a channel of a pixel.
struct OverSeeds {
  glm::dvec3 mean{0}, variance{0};
  double count = 0;
};

OverSeeds overSeeds(Cell& cell, uint32_t seeds) {
  OverSeeds m;
  glm::dvec3 squares(0);
  for (uint32_t seed = 1; seed <= seeds; ++seed) {
    cell.renderer().setSeed(seed);
    cell.renderAgain();
    const auto picture = cell.picture().rgba;
    for (size_t i = 0; i < picture.size(); i += 4) {
      const glm::dvec3 c(picture[i], picture[i + 1], picture[i + 2]);
      m.mean += c;
      squares += c * c;
      ++m.count;
    }
  }
  m.mean /= m.count;
  m.variance = squares / m.count - m.mean * m.mean;
  return m;
}

/// Expectation of the corrected estimate, over all sets of samples that each layer may keep.
/// `nearest`: of each sample, the layer that its depth is of (or the number of layers).
glm::dvec3 correctedMean(const std::vector<Pane>& list, uint32_t samples,
                         std::vector<size_t> nearest = {}, size_t layer = 0) {
  if (layer == 0) nearest.assign(samples, list.size());
  if (layer == list.size()) {
    glm::dvec3 sum(0);
    double weight = 0;
    for (size_t i = 0; i < list.size(); ++i)
      for (const size_t n : nearest)
        if (i <= n) {
          sum += double(list[i].alpha) * glm::dvec3(list[i].color);
          weight += double(list[i].alpha);
        }
    return sum / weight;
  }
  const double kept = double(list[layer].alpha) * samples;
  const double more = kept - std::floor(kept);
  double ways[5] = {};
  for (uint32_t set = 0; set < 1u << samples; ++set) ++ways[std::popcount(set)];
  glm::dvec3 mean(0);
  for (uint32_t set = 0; set < 1u << samples; ++set) {
    const double count = std::popcount(set);
    const double likely = count == std::floor(kept)       ? 1 - more
                          : count == std::floor(kept) + 1 ? more
                                                          : 0;
    if (likely == 0) continue;
    std::vector<size_t> next = nearest;
    for (uint32_t s = 0; s < samples; ++s)
      if (set >> s & 1) next[s] = std::min(next[s], layer);
    mean += likely / ways[std::popcount(set)] * correctedMean(list, samples, next, layer + 1);
  }
  return mean;
}

}  // namespace

GPU_TEST(StochasticTransparency, BasicIsRightInExpectation) {
  const glm::vec3 background(0, 0, 1);
  const std::vector<Pane> cases[] = {
      {{{1, 0, 0}, 0.3f}},
      {{{1, 0, 0}, 0.5f}, {{0, 1, 0}, 0.5f}},
      {{{0.5f, 0.25f, 0}, 0.7f}, {{0, 1, 0.5f}, 0.2f}, {{1, 0, 0.25f}, 0.9f}}};
  for (const char* samples : {"1", "4"})
    for (const auto& list : cases) {
      SCOPED_TRACE(std::string(samples) + " samples, layers " + std::to_string(list.size()));
      Cell cell(cellDevice(device()), stack(list, background), stochastic(samples, "basic"));
      const OverSeeds m = overSeeds(cell, 48);
      const glm::vec3 exact = composed(list, background);
      for (int c = 0; c < 3; ++c)
        EXPECT_LE(std::abs(m.mean[c] - double(exact[c])),
                  4 * std::sqrt(m.variance[c] / m.count) + 0x1p-12)
            << c;
      // One layer of alpha 0.3: variance f (1 - f) / S^2 with f the fraction of alpha S.
      if (list.size() != 1) continue;
      const double s = std::stod(samples), f = 0.3 * s - std::floor(0.3 * s);
      EXPECT_NEAR(m.variance[0] / (f * (1 - f) / (s * s)), 1, 0.05);
    }
}

GPU_TEST(StochasticTransparency, CorrectedIsExactForOneLayerAndLessNoisy) {
  const glm::vec3 background(0.25f, 0.5f, 1);
  for (const char* samples : {"1", "4"}) {
    SCOPED_TRACE(samples);
    const std::vector<Pane> one = {{{1, 0.5f, 0.25f}, 0.3f}};
    expectColor(rendered(device(), stack(one, background), stochastic(samples, "corrected")),
                composed(one, background), 0x1p-9f);
    const auto list = panes(4, 0.4f);
    Cell basic(cellDevice(device()), stack(list, background), stochastic(samples, "basic"));
    Cell corrected(cellDevice(device()), stack(list, background), stochastic(samples, "corrected"));
    const OverSeeds a = overSeeds(basic, 8), b = overSeeds(corrected, 8);
    EXPECT_LT(b.variance[0] + b.variance[1] + b.variance[2],
              0.5 * (a.variance[0] + a.variance[1] + a.variance[2]));
    // Biased: by as much as the estimate is in expectation.
    double through = 1;
    for (const Pane& p : list) through *= 1 - double(p.alpha);
    const glm::dvec3 expected = through * glm::dvec3(background) +
                                (1 - through) * correctedMean(list, samples[0] == '1' ? 1 : 4);
    for (int c = 0; c < 3; ++c)
      EXPECT_LE(std::abs(b.mean[c] - expected[c]),
                4 * std::sqrt(b.variance[c] / b.count) + 0x1p-10);
  }
}

GPU_TEST(StochasticTransparency, CorrectedKeepsOpacityAndEnergyWhateverTheLayers) {
  // Total opacity is exact: black panes before white leave prod(1 - a).
  std::vector<Pane> list;
  for (const float alpha : {0.1f, 0.6f, 0.33f, 0.5f, 0.25f}) list.push_back({{0, 0, 0}, alpha});
  for (const char* samples : {"1", "4"}) {
    expectColor(rendered(device(), stack(list, {1, 1, 1}), stochastic(samples, "corrected")),
                composed(list, {1, 1, 1}), 0x1p-10f);
    auto even = list;
    const glm::vec3 color(0.3f, 0.6f, 0.9f);
    for (Pane& p : even) p.color = color;
    for (const char* mode : {"basic", "corrected"})
      expectColor(rendered(device(), stack(even, color), stochastic(samples, mode)), color,
                  0x1p-9f);
  }
}

GPU_TEST(StochasticTransparency, LayersThatDoNotExistAndLayersThatHideAll) {
  auto list = panes(5, 0.5f);
  list.front() = {{0.25f, 0.5f, 0.75f}, kAll};
  Scene opaque = tangle(), clear = tangle();
  opaque.instances.resize(2);
  for (size_t m = 1; m < clear.materials.size(); ++m) clear.materials[m].overrideAlpha = 0;
  for (const char* samples : {"1", "4"})
    for (const char* mode : {"basic", "corrected"}) {
      SCOPED_TRACE(std::string(samples) + mode);
      expectColor(rendered(device(), stack(list, {4, 4, 4}), stochastic(samples, mode)),
                  {0.25f, 0.5f, 0.75f}, 0x1p-11f);
      EXPECT_EQ(rendered(device(), opaque, stochastic(samples, mode, {64, 48})),
                rendered(device(), clear, stochastic(samples, mode, {64, 48})));
    }
}

GPU_TEST(StochasticTransparency, OrderOfTheSourcePlaysNoPart) {
  for (const char* samples : {"1", "4"})
    for (const char* mode : {"basic", "corrected"}) {
      const auto options = stochastic(samples, mode, {64, 48});
      const auto before = rendered(device(), tangle(), options);
      for (const uint64_t seed : {1u, 2u, 3u}) {
        Scene permuted = tangle();
        permuteScene(permuted, seed);
        const auto after = rendered(device(), permuted, options);
        // basic shows the stochastic depth map itself; corrected sums in the order of drawing, in
        // half floats.
        if (mode == std::string("basic"))
          EXPECT_EQ(before, after) << samples << seed;
        else
          EXPECT_LE(largestDifference(before, after), 0x1p-7f) << samples << seed;
      }
    }
}

GPU_TEST(StochasticTransparency, SeedsGiveOtherNumbersAndOneSeedTheSame) {
  Cell cell(cellDevice(device()), stack(panes(3, 0.4f), {0, 0, 1}), stochastic("4", "basic"));
  const auto first = cell.picture().rgba;
  cell.renderer().setSeed(7);
  cell.renderAgain();
  EXPECT_NE(first, cell.picture().rgba);
  cell.renderer().setSeed(0);
  cell.renderAgain();
  EXPECT_EQ(first, cell.picture().rgba);
}
