// Drawn analytically in polar coordinates, from the centre outward: an eight-lobed heart, eight
// petals, a string of beads, sixteen lancets with medallions over latticed pale glass, thirty-two
// roundels, the stone rim, and a small oculus in each corner. 9 samples a texel.
#include "suites/scenes/procedural/translucent/rose_window.h"

#include <algorithm>
#include <cmath>

namespace sb {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct Glass {
  glm::dvec3 colour;
  double alpha;
};
constexpr Glass kLead{{0, 0, 0}, 1};
constexpr Glass kRuby{{0.90, 0.015, 0.03}, 1};
constexpr Glass kCobalt{{0.02, 0.07, 0.90}, 1};
constexpr Glass kEmerald{{0.03, 0.62, 0.12}, 0.95};
constexpr Glass kViolet{{0.42, 0.05, 0.75}, 0.95};
constexpr Glass kGold{{1.0, 0.68, 0.06}, 0.85};
constexpr Glass kIce{{0.75, 0.90, 1.0}, 0.30};
constexpr Glass kAmber{{1.0, 0.90, 0.62}, 0.40};
constexpr Glass kClear{{1, 1, 1}, 0.15};

// Half widths of lead, in units of half the window.
constexpr double kStone = 0.009, kBar = 0.0055, kFine = 0.0021;

// One point of the window: its glass, unless a line of lead is near enough.
class Point {
 public:
  Point(double x, double y) : m_x(x), m_y(y), m_r(std::hypot(x, y)), m_angle(std::atan2(x, y)) {}

  Glass glass() {
    Glass found = kLead;
    if (m_r < 0.17)
      found = heart();
    else if (m_r < 0.40)
      found = petals();
    else if (m_r < 0.44)
      found = beads();
    else if (m_r < 0.79)
      found = lancets();
    else if (m_r < 0.965)
      found = roundels();
    else
      found = corners();
    for (const double ring : {0.17, 0.40, 0.44, 0.79, 0.965}) line(m_r - ring, kStone);
    return m_lead ? kLead : found;
  }

 private:
  // Lead where `distance` from a border is less than `halfWidth`. Returns whether inside (< 0).
  bool line(double distance, double halfWidth) {
    m_lead |= std::abs(distance) < halfWidth;
    return distance < 0;
  }
  // Splits the circle into `count` sectors; `away` is the angle from the middle of this one.
  int sector(int count, double& away) const {
    const double turns = m_angle / (2 * kPi) * count;
    const double nearest = std::round(turns);
    away = (turns - nearest) * 2 * kPi / count;
    return (int(nearest) % count + count) % count;
  }
  // Distance to a point at radius `r` on the middle of a sector.
  double toMiddle(double r, double away) const {
    return std::hypot(m_r * std::cos(away) - r, m_r * std::sin(away));
  }
  double toSpoke(int count, double away) const {
    return m_r * std::sin(std::abs(away) - kPi / count);
  }

  Glass heart() {
    double away;
    const int i = sector(8, away);
    if (line(m_r - 0.045, kBar)) return kClear;
    line(toSpoke(8, away), kFine);
    if (line(toMiddle(0.105, away) - 0.038, kBar)) return i % 2 ? kRuby : kGold;
    return kCobalt;
  }

  Glass petals() {
    double away;
    const int i = sector(8, away);
    const double across = m_r * std::sin(away), along = m_r * std::cos(away) - 0.285;
    const double e = std::hypot(along / 0.098, across / 0.086);
    line(toSpoke(8, away), kBar);
    if (line((e - 1) * 0.088, kBar)) {
      if (line((e - 0.55) * 0.088, kFine)) {
        line(across, kFine);
        return along > 0 ? kAmber : kIce;
      }
      line(along, kFine);
      return i % 2 ? kViolet : kEmerald;
    }
    return m_r < 0.285 ? kGold : kCobalt;
  }

  Glass beads() {
    double away;
    const int i = sector(48, away);
    line(toSpoke(48, away), kFine);
    return i % 2 ? kRuby : kClear;
  }

  Glass lancets() {
    double away;
    const int i = sector(16, away);
    const double side = toSpoke(16, away);
    line(side, kBar);
    // The head is round: its centre sits where the circle touches both spokes.
    const double center = 0.64, head = center * std::sin(kPi / 16);
    const double border = m_r * std::cos(away) > center ? toMiddle(center, away) - head : side;
    if (!line(border, kBar)) {
      line(m_r - 0.735, kFine);
      return m_r > 0.735 ? kViolet : kGold;
    }
    if (!line(border + 0.024, kFine)) {
      // Short bars cut the coloured strip into small panes.
      line(std::remainder(m_r - 0.44, 0.045), kFine);
      return i % 2 ? kRuby : kCobalt;
    }
    if (line(toMiddle(0.65, away) - 0.062, kBar)) {
      if (line(toMiddle(0.65, away) - 0.030, kFine)) return i % 2 ? kAmber : kClear;
      line(m_r * std::sin(away), kFine);
      return i % 2 ? kEmerald : kRuby;
    }
    if (line(toMiddle(0.525, away) - 0.036, kBar)) return i % 2 ? kCobalt : kGold;
    lattice(m_r * std::sin(away), m_r * std::cos(away), 0.034);
    return i % 2 ? kIce : kAmber;
  }

  void lattice(double across, double along, double pitch) {
    line(std::remainder(across + 0.6 * along, pitch) * 0.857, kFine);
    line(std::remainder(across - 0.6 * along, pitch) * 0.857, kFine);
  }

  Glass roundels() {
    double away;
    const int i = sector(32, away);
    const double to = toMiddle(0.878, away);
    line(toSpoke(32, away), kFine);
    if (!line(to - 0.076, kBar)) return m_r < 0.878 ? kEmerald : kViolet;
    if (!line(to - 0.046, kFine)) {
      line(m_r * std::sin(away), kFine);
      return i % 2 ? kCobalt : kRuby;
    }
    if (line(to - 0.018, kFine)) return i % 2 ? kRuby : kCobalt;
    return i % 2 ? kAmber : kIce;
  }

  Glass corners() {
    const double x = std::abs(m_x) - 0.845, y = std::abs(m_y) - 0.845;
    const double to = std::hypot(x, y);
    if (!line(to - 0.115, kStone)) return kLead;
    line(x, kFine), line(y, kFine);
    return line(to - 0.055, kBar) ? kGold : kCobalt;
  }

  double m_x, m_y, m_r, m_angle;
  bool m_lead = false;
};

double toSrgb(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

uint8_t toByte(double value) { return uint8_t(std::lround(255 * std::clamp(value, 0.0, 1.0))); }

}  // namespace

Image roseWindowImage(uint32_t size) {
  constexpr int kGrid = 3;
  Image image{"rose window", size, size, std::vector<uint8_t>(size_t(size) * size * 4)};
  for (uint32_t row = 0; row < size; ++row)
    for (uint32_t column = 0; column < size; ++column) {
      glm::dvec3 colour(0);
      double alpha = 0;
      for (int s = 0; s < kGrid * kGrid; ++s) {
        const double x = 2 * (column + (s % kGrid + 0.5) / kGrid) / size - 1;
        const double y = 1 - 2 * (row + (s / kGrid + 0.5) / kGrid) / size;
        const Glass glass = Point(x, y).glass();
        colour += glass.colour * glass.alpha;
        alpha += glass.alpha;
      }
      colour /= alpha;  // never 0: the clearest glass has some
      uint8_t* texel = image.rgba.data() + 4 * (size_t(row) * size + column);
      for (int c = 0; c < 3; ++c) texel[c] = toByte(toSrgb(colour[c]));
      texel[3] = toByte(alpha / (kGrid * kGrid));
    }
  return image;
}

}  // namespace sb
