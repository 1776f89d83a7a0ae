// Shares of a light that a polygon hides, by brute force: another way than any technique's.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

namespace sb::test {

/// Share of the unit disc (`round`), or of the square from -1 to 1, that lies within a polygon: by
/// where so many lines cross it.
inline double scannedShare(const std::vector<glm::dvec2>& polygon, bool round, int lines) {
  double area = 0;
  for (int k = 0; k < lines; ++k) {
    const double y = -1 + (k + 0.5) * 2 / lines, half = round ? std::sqrt(1 - y * y) : 1;
    std::vector<double> crossings;
    for (size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if ((a.y <= y) == (b.y <= y)) continue;
      crossings.push_back(std::clamp(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), -half, half));
    }
    std::ranges::sort(crossings);
    for (size_t i = 0; i + 1 < crossings.size(); i += 2) area += crossings[i + 1] - crossings[i];
  }
  return area * 2 / lines / (round ? std::numbers::pi : 4);
}

}  // namespace sb::test
