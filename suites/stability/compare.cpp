// What several cases compare of probes.
#include <algorithm>

#include "suites/harness/checks/verify.h"
#include "suites/stability/case.h"

namespace sb {

double changedInside(Probe& before, Probe& after, uint32_t light) {
  const auto &a = before.visibility(light)[0], &b = after.visibility(light)[0];
  const int width = int(before.size().width), height = int(before.size().height);
  const auto at = [&](const VisibilityImage& image, int x, int y) {
    return image.begin() + 4 * (ptrdiff_t(y) * width + x);
  };
  Compared changed;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto own = at(a, x, y);
      if (own[3] == 0 && at(b, x, y)[3] == 0) continue;
      bool edge = false;
      for (int v = std::max(0, y - 2); v <= std::min(height - 1, y + 2); ++v)
        for (int u = std::max(0, x - 2); u <= std::min(width - 1, x + 2); ++u)
          edge |= !std::equal(own, own + 4, at(a, u, v));
      if (!edge) changed.count(!std::equal(own, own + 4, at(b, x, y)));
    }
  return changed.value();
}

double badValues(Probe& probe) {
  double bad = double(countNonFinite(probe.picture()));
  for (const uint32_t light : probe.renderer().lights())
    for (const VisibilityImage& layer : probe.visibility(light))
      bad += double(std::ranges::count_if(layer, [](float v) { return !(v >= 0 && v <= 1); }));
  return bad;
}

}  // namespace sb
