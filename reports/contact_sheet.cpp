#include "reports/contact_sheet.h"

#include <algorithm>

namespace report {
namespace {

constexpr float kNothing = 0.05f;
constexpr uint32_t kGap = 2;

/// Mean of a block of a cell over `kNothing`.
void shrink(std::span<const float> cell, uint32_t width, uint32_t height, uint32_t x0, uint32_t y0,
            uint32_t factor, float* out) {
  const uint32_t x1 = std::min(width, x0 + factor), y1 = std::min(height, y0 + factor);
  const float count = float(x1 - x0) * float(y1 - y0);
  float sum[3] = {0, 0, 0};
  for (uint32_t y = y0; y < y1; ++y)
    for (uint32_t x = x0; x < x1; ++x) {
      const float* v = cell.data() + 4 * (size_t(y) * width + x);
      for (size_t c = 0; c < 3; ++c) sum[c] += v[3] == 0 ? kNothing : v[c];
    }
  for (size_t c = 0; c < 3; ++c) out[c] = sum[c] / count;
}

}  // namespace

Picture contactSheet(uint32_t width, uint32_t height, std::span<const std::span<const float>> cells,
                     uint32_t columns, uint32_t side) {
  const uint32_t rows = (uint32_t(cells.size()) + columns - 1) / columns;
  uint32_t factor = 1, w = width, h = height;
  const auto tooLarge = [&] {
    return uint64_t(columns) * (w + kGap) > side + kGap || uint64_t(rows) * (h + kGap) > side + kGap;
  };
  while (tooLarge() && (w > 1 || h > 1)) {
    ++factor;
    w = (width + factor - 1) / factor;
    h = (height + factor - 1) / factor;
  }
  Picture sheet{columns * (w + kGap) - kGap, rows * (h + kGap) - kGap, {}};
  sheet.rgba.assign(size_t(sheet.width) * sheet.height * 4, kNothing);
  for (size_t p = 3; p < sheet.rgba.size(); p += 4) sheet.rgba[p] = 1;
  for (size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].empty()) continue;
    const uint32_t left = uint32_t(i % columns) * (w + kGap);
    const uint32_t bottom = (rows - 1 - uint32_t(i / columns)) * (h + kGap);
    for (uint32_t y = 0; y < h; ++y)
      for (uint32_t x = 0; x < w; ++x)
        shrink(cells[i], width, height, x * factor, y * factor, factor,
               sheet.rgba.data() + 4 * (size_t(bottom + y) * sheet.width + left + x));
  }
  return sheet;
}

}  // namespace report
