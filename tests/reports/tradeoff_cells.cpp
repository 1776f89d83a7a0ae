#include "tests/reports/tradeoff_cells.h"

namespace report {

Record cell(const std::string& technique, double time, double error, const std::string& size) {
  Record r;
  r.technique = technique;
  r.transparency = "Sorted";
  r.backend = "vulkan";
  r.device = "llvmpipe";
  r.deviceType = "software";
  r.scene = "layers";
  r.width = 64;
  r.height = 32;
  r.name = technique + "/vulkan/layers/64x32";
  if (!size.empty()) {
    r.knobs["size"] = size;
    r.name += "/size:" + size;
  }
  r.cpu = Distribution{.median = time, .n = 1};
  r.frame = Distribution{.median = 2 * time, .n = 1};
  r.visibility = VisibilityError{};
  r.visibility->all.rmse = error;
  r.image = ImageError{};
  r.image->all.rmse = error / 2;
  r.bytes = 1 << 20;
  return r;
}

Record tracer(double time) {
  Record r = cell("RayTraced", time, 0);
  r.name = "RayTraced/cpu/layers/64x32";
  r.backend = "cpu";
  r.device = "processor";
  r.transparency.clear();
  return r;
}

void spread(Record& r, double spread) {
  for (double offset : {-1.0, 0.0, 1.0}) {
    const double time = r.cpu->median + offset * spread;
    r.blocks.push_back({.frames = 1, .frameMs = 2 * time, .cpuMs = time});
  }
}

void noisy(Record& r, double low, double high) {
  r.noise = NoiseRecord{.seeds = 8, .rmseLow = low, .rmseHigh = high};
}

}  // namespace report
