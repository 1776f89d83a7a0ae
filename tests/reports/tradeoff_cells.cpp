#include "tests/reports/tradeoff_cells.h"

namespace report {

Record cell(const std::string& technique, double time, double error, const std::string& size) {
  Record r;
  r.id = {
      .technique = technique, .backend = "vulkan", .scene = "layers", .width = 64, .height = 32};
  r.device = "llvmpipe";
  r.deviceType = "software";
  if (!size.empty()) {
    r.knobs["size"] = size;
    r.id.knobs = {{"size", size}};
  }
  r.name = cellName(r.id);
  r.cpu = Distribution{.median = time, .n = 1};
  r.frame = Distribution{.median = 2 * time, .n = 1};
  r.visibility = VisibilityError{};
  r.visibility->all.rmse = error;
  r.image = ImageError{};
  r.image->all.rmse = error / 2;
  r.bytes = 1 << 20;
  return r;
}

Record baseline(double time, double error) {
  Record r = cell("none", time, error);
  r.role = Role::Baseline;
  return r;
}

Record tracer(double time) {
  Record r = cell("RayTraced", time, 0);
  r.role = Role::Tracer;
  r.id.backend = "cpu";
  r.name = cellName(r.id);
  r.device = "processor";
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
