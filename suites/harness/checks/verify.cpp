#include "suites/harness/checks/verify.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "suites/harness/cell.h"

namespace sb {

std::string contentHashOf(const report::Picture& picture) {
  return report::contentHash(std::as_bytes(std::span(picture.rgba)));
}

uint64_t countNonFinite(const report::Picture& picture) {
  return uint64_t(std::ranges::count_if(picture.rgba, [](float v) { return !std::isfinite(v); }));
}

int maxDifference255(const report::Picture& a, const report::Picture& b, float exposure) {
  if (a.width != b.width || a.height != b.height) return 255;
  const auto x = report::toSrgb8(a, exposure), y = report::toSrgb8(b, exposure);
  int most = 0;
  for (size_t i = 0; i < x.size(); ++i) most = std::max(most, std::abs(int(x[i]) - int(y[i])));
  return most;
}

uint64_t pixelsBeyondOneStep(const report::Picture& a, const report::Picture& b,
                             float exposure) {
  if (a.width != b.width || a.height != b.height) return uint64_t(a.width) * a.height;
  const auto x = report::toSrgb8(a, exposure), y = report::toSrgb8(b, exposure);
  uint64_t count = 0;
  for (size_t i = 0; i + 2 < x.size(); i += 3)
    count += std::abs(int(x[i]) - int(y[i])) > 1 || std::abs(int(x[i + 1]) - int(y[i + 1])) > 1 ||
             std::abs(int(x[i + 2]) - int(y[i + 2])) > 1;
  return count;
}

bool isUniform(const report::Picture& picture) {
  for (size_t i = 4; i < picture.rgba.size(); ++i)
    if (picture.rgba[i] != picture.rgba[i % 4]) return false;
  return true;
}

std::string whyRefused(const report::Record& record) {
  if (!record.stable || !record.nonfinite) return "the picture was not verified";
  if (record.drawCount == 0 && record.role != report::Role::Tracer)
    return "nothing of the scene was drawn";
  if (*record.nonfinite > 0)
    return std::to_string(*record.nonfinite) + " values of the picture are not finite";
  if (!*record.stable) return "the timed run's picture differs from the untimed one";
  return "";
}

}  // namespace sb
