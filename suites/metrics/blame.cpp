#include "suites/metrics/blame.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "suites/metrics/srgb.h"

namespace sb {
namespace {

/// Smaller errors are no reason to look for a shadow's edge.
constexpr float kVisible = 1.0f / 255;
/// A truth that varies less has no edge: textures vary smoothly.
constexpr float kJump = 1.0f / 64;

bool explains(const ValueRange& around, size_t channel, float value) {
  const float low = around.low[channel], high = around.high[channel];
  return high - low > kJump && value >= low - kVisible && value <= high + kVisible;
}

}  // namespace

const char* causeName(Cause cause) {
  switch (cause) {
    case Cause::Noise: return "noise";
    case Cause::Resolution: return "resolution";
    case Cause::InnerLayer: return "inner-layer";
    case Cause::Penumbra:
      return "penumbra";
    case Cause::SelfShadowing: return "self-shadowing";
    case Cause::Leaking: return "leaking";
  }
  return "";
}

std::array<uint8_t, 3> causeColor(Cause cause) {
  // Okabe and Ito's colours for all kinds of colour vision.
  switch (cause) {
    case Cause::Noise: return {204, 121, 167};
    case Cause::Resolution: return {86, 180, 233};
    case Cause::InnerLayer: return {0, 158, 115};
    case Cause::Penumbra:
      return {0, 114, 178};
    case Cause::SelfShadowing: return {213, 94, 0};
    case Cause::Leaking: return {240, 228, 66};
  }
  return {};
}

BlameSum::BlameSum(uint32_t width, uint32_t height)
    : m_width(width), m_height(height), m_squares(size_t(width) * height) {}

void BlameSum::add(const BlameInput& in) {
  const bool stochastic = !in.mean.empty();
  const Values values = stochastic ? in.mean : in.measured;
  for (size_t p = 0; p < m_squares.size(); ++p) {
    if (values[4 * p + 3] != 1 || in.truth[4 * p + 3] != 1) continue;
    float error[3], largest = 0;
    for (size_t c = 0; c < 3; ++c) {
      error[c] = values[4 * p + c] - in.truth[4 * p + c];
      largest = std::max(largest, std::abs(error[c]));
      if (stochastic) m_squares[p][size_t(Cause::Noise)] += in.variance[4 * p + c];
    }
    m_values += 3;
    const auto varies = [&](size_t c) { return stochastic && in.variance[4 * p + c] > 0; };
    if (largest == 0 && !varies(0) && !varies(1) && !varies(2)) continue;
    std::optional<ValueRange> around;
    if (in.truthAround && largest > kVisible)
      around = in.truthAround(uint32_t(p % m_width), uint32_t(p / m_width));
    // Before a translucent receiver that all light reaches lies no other layer.
    const bool inner = in.surfaces[p] == 2 &&
                       std::min({in.truth[4 * p], in.truth[4 * p + 1], in.truth[4 * p + 2]}) < 1;
    for (size_t c = 0; c < 3; ++c) {
      const float truth = in.truth[4 * p + c];
      const Cause cause = around && explains(*around, c, values[4 * p + c]) ? Cause::Resolution
                          : inner                                           ? Cause::InnerLayer
                          : in.areaLight && truth > 0 && truth < 1          ? Cause::Penumbra
                          : error[c] < 0                                    ? Cause::SelfShadowing
                                                                            : Cause::Leaking;
      const float ofMean = stochastic ? in.variance[4 * p + c] / float(in.seeds) : 0.0f;
      m_squares[p][size_t(cause)] += error[c] * error[c] - ofMean;
    }
  }
}

report::Blame BlameSum::blame() const {
  double sums[kCauses] = {}, total = 0;
  for (const auto& squares : m_squares)
    for (size_t k = 0; k < kCauses; ++k) sums[k] += double(squares[k]);
  for (double& s : sums) total += s = std::max(0.0, s);
  report::Blame blame{.mse = m_values ? total / double(m_values) : 0, .shares = {}};
  if (total == 0) return blame;
  for (size_t k = 0; k < kCauses; ++k)
    blame.shares.emplace_back(causeName(Cause(k)), sums[k] / total);
  return blame;
}

std::vector<uint8_t> BlameSum::picture() const {
  std::vector<uint8_t> rgb(m_squares.size() * 3);
  for (uint32_t y = 0; y < m_height; ++y)
    for (uint32_t x = 0; x < m_width; ++x) {
      const auto& squares = m_squares[size_t(y) * m_width + x];
      double sum = 0;
      for (const float s : squares) sum += double(std::max(0.0f, s));
      const auto largest = size_t(std::ranges::max_element(squares) - squares.begin());
      const auto color = causeColor(Cause(largest));
      uint8_t* out = rgb.data() + 3 * (size_t(m_height - 1 - y) * m_width + x);
      const double brightness = std::min(1.0, std::sqrt(sum / 3));
      for (size_t c = 0; c < 3; ++c)
        out[c] = encodeSrgb8(brightness * decodeSrgb(color[c] / 255.0));
    }
  return rgb;
}

}  // namespace sb
