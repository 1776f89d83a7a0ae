// Named figures of a cell, for statements and tables:
//   time                compared time: CPU time on software devices, else the frame's, ms
//   cpu_ms frame_ms     medians
//   shadow_ms scene_ms combined_ms stamped_frame_ms    from frames with stamps between passes
//   passes draws triangles bytes    of a frame; passes:GLOB ... bytes:GLOB by label
//   counts:NAME         what the technique counts: "counts:volumes drawn"
//   visibility image    RMSE; also visibility_interior (away from edges) visibility_bias flip noise
//   layer:N             visibility RMSE of layer N (0: first opaque surface)
//   region:NAME region_noise:NAME    visibility RMSE and noise of a region
#pragma once

#include <optional>
#include <string>

#include "reports/figure.h"
#include "reports/record.h"

namespace report {

struct Measured {
  double value = 0;
  double halfWidth = 0;  ///< of a 95 % interval; 0: exact, or not known
};

/// Nothing when the record lacks it; contaminated times are lacking.
std::optional<Measured> measured(const Record& record, const std::string& measure);
/// Is there such a measure?
bool isMeasure(const std::string& measure);
bool isTime(const std::string& measure);
/// "combined time, ms"
std::string measureTitle(const std::string& measure);

/// The cell's value of the figure's x.
double xOf(const Figure& figure, const Record& record);
/// The scene without the figure's x.
std::string sceneWithoutX(const Figure& figure, const Record& record);

}  // namespace report
