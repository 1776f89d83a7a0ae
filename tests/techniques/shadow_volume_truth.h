// Shadow volumes against ray-traced visibility, pixel by pixel (spec 17, N2).
#pragma once

#include "suites/truth/tracer.h"
#include "tests/techniques/gpu_cell.h"

namespace sb::test {

/// Of the first opaque surface, all lights together.
struct ShadowMismatch {
  size_t compared = 0;   ///< pixels of which the truth asks for the light
  size_t dark = 0;       ///< of these in shadow
  size_t edge = 0;       ///< pixels of shadow edges and silhouettes
  size_t atEdges = 0;    ///< wrong among these
  size_t elsewhere = 0;  ///< wrong at other pixels
  std::string first;     ///< of those elsewhere
};

inline ShadowMismatch shadowMismatch(Cell& cell, uint32_t layer = 0) {
  const auto [width, height] = cell.size();
  const Scene scene = cell.scene();
  const Truth truth = *sb::Tracer(scene, width, height).trace({.width = width, .height = height});
  ShadowMismatch m;
  for (const uint32_t light : cell.renderer().lights()) {
    const std::vector<float>& expected = truth.visibility[light * kTruthLayers + layer];
    const std::vector<uint8_t>& edges = truth.edges[light * kTruthLayers + layer];
    const VisibilityImage& found = cell.visibility(light)[layer];
    for (size_t i = 0; i < size_t(width) * height; ++i) {
      if (expected[4 * i + 3] == 0 || found[4 * i + 3] == 0) continue;
      ++m.compared;
      m.dark += expected[4 * i] == 0;
      m.edge += edges[i];
      if (found[4 * i] == expected[4 * i]) continue;
      (edges[i] ? m.atEdges : m.elsewhere)++;
      if (!edges[i] && m.first.empty())
        m.first = "light " + std::to_string(light) + ", pixel " + std::to_string(i % width) + ", " +
                  std::to_string(i / width) + ": " + std::to_string(found[4 * i]);
    }
  }
  return m;
}

/// N2: one pixel in 64 of an edge, and 4; none elsewhere. Edges are marked 2 pixels to each side.
inline void expectExact(Cell& cell, const std::string& what, size_t minDark = 20) {
  const ShadowMismatch m = shadowMismatch(cell);
  EXPECT_EQ(m.elsewhere, 0u) << what << ", " << m.first;
  EXPECT_LE(double(m.atEdges), double(m.edge) / 5 / 64 + 4) << what;
  EXPECT_GE(m.dark, minDark) << what;
  EXPECT_GE(m.compared, 200u) << what;
}

}  // namespace sb::test
