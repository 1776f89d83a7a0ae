#include "techniques/maps/noise_tiles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "shaders/common/shared_hash.h"

namespace sb {
namespace {

uint32_t word(uint32_t i, uint32_t purpose) { return gpu::pcg4d({i, purpose, 0x0A11u, 0x5EEDu}).x; }

std::vector<uint32_t> randomOrder(uint32_t count, uint32_t purpose) {
  std::vector<uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  for (uint32_t i = count - 1; i > 0; --i)
    std::swap(order[i], order[uint64_t(word(i, purpose)) * (i + 1) >> 32]);
  return order;
}

/// Texels that are set, and how crowded every texel of the tile is: a sum of bells around the set
/// ones. In whole numbers, so that taking away restores what adding changed, on every machine.
class Crowd {
 public:
  Crowd() : m_energy(kCount), m_set(kCount) {
    for (int d = -kReach; d <= kReach; ++d)
      m_bell[size_t(d + kReach)] = std::exp(-double(d * d) / (2 * kSigma * kSigma));
  }

  bool isSet(uint32_t i) const { return m_set[i]; }
  void set(uint32_t i, bool on) {
    m_set[i] = on;
    const int x0 = int(i % kBlueWidth), y0 = int(i / kBlueWidth);
    for (int y = -kReach; y <= kReach; ++y)
      for (int x = -kReach; x <= kReach; ++x) {
        const int64_t bell =
            std::llround(0x1p24 * m_bell[size_t(x + kReach)] * m_bell[size_t(y + kReach)]);
        m_energy[wrap(y0 + y) * kBlueWidth + wrap(x0 + x)] += on ? bell : -bell;
      }
  }

  uint32_t tightestCluster() const {
    uint32_t best = kCount;
    for (uint32_t i = 0; i < kCount; ++i)
      if (m_set[i] && (best == kCount || m_energy[i] > m_energy[best])) best = i;
    return best;
  }
  uint32_t largestVoid() const {
    uint32_t best = kCount;
    for (uint32_t i = 0; i < kCount; ++i)
      if (!m_set[i] && (best == kCount || m_energy[i] < m_energy[best])) best = i;
    return best;
  }

  static constexpr uint32_t kCount = kBlueWidth * kBlueWidth;

 private:
  static uint32_t wrap(int v) { return uint32_t(v) % kBlueWidth; }
  static constexpr double kSigma = 1.5;  // Ulichney's choice
  static constexpr int kReach = 8;       // the bell is below 1e-6 there
  std::vector<int64_t> m_energy;
  std::vector<char> m_set;
  double m_bell[2 * kReach + 1];
};

std::vector<float> makeBlue() {
  Crowd crowd;
  const uint32_t first = Crowd::kCount / 10;
  const std::vector<uint32_t> order = randomOrder(Crowd::kCount, 2);
  for (uint32_t i = 0; i < first; ++i) crowd.set(order[i], true);
  // Clusters move into voids until the tightest cluster is the largest void.
  for (;;) {
    const uint32_t from = crowd.tightestCluster();
    crowd.set(from, false);
    const uint32_t to = crowd.largestVoid();
    crowd.set(to, true);
    if (to == from) break;
  }
  std::vector<uint32_t> rank(Crowd::kCount);
  const Crowd start = crowd;
  for (uint32_t r = first; r-- > 0;) {
    const uint32_t i = crowd.tightestCluster();
    crowd.set(i, false);
    rank[i] = r;
  }
  crowd = start;
  // The rest by the largest void: for these bells that orders the second half too (Ulichney's third
  // phase asks for the tightest cluster of what is not set, which has the same sum).
  for (uint32_t r = first; r < Crowd::kCount; ++r) {
    const uint32_t i = crowd.largestVoid();
    crowd.set(i, true);
    rank[i] = r;
  }
  std::vector<float> tile;
  for (const uint32_t r : rank) tile.push_back(float(r) / Crowd::kCount);
  return tile;
}

}  // namespace

const std::vector<float>& whiteTile() {
  static const std::vector<float> tile = [] {
    constexpr uint32_t kCount = kWhiteWidth * kWhiteWidth;
    std::vector<float> t;
    for (const uint32_t part : randomOrder(kCount, 1))
      t.push_back(float((part << 8) | (word(part, 3) >> 24)) * 0x1p-24f);
    return t;
  }();
  return tile;
}

const std::vector<float>& blueTile() {
  static const std::vector<float> tile = makeBlue();
  return tile;
}

const std::vector<uint8_t>& sourceTile() {
  static const std::vector<uint8_t> tile = [] {
    std::vector<uint8_t> t;
    t.reserve(4ull * kSourceWidth * kSourceWidth);
    for (uint32_t i = 0; i < kSourceWidth * kSourceWidth; ++i) {
      const glm::uvec4 h = gpu::pcg4d({i % kSourceWidth, i / kSourceWidth, 4u, 0x5EEDu});
      for (int c = 0; c < 4; ++c) t.push_back(uint8_t(h[c] >> 24));
    }
    return t;
  }();
  return tile;
}

}  // namespace sb
