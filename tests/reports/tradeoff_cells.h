// Cells made by hand for tests of trade-offs: one scene, size and device, so that a test changes
// only what it is about. All on a software device unless the test says otherwise; the image's error
// is half that of visibility, and frames take twice the CPU time, so that none can be taken for
// another.
#pragma once

#include <string>

#include "reports/record.h"
#include "reports/stats/tradeoff.h"

namespace report {

/// Its CPU time compares. No blocks, so the time's interval is a point.
Record cell(const std::string& technique, double time, double error, const std::string& size = "");
/// The same without shadows.
Record baseline(double time, double error);
/// The tracer's cell, error 0, on the same scene.
Record tracer(double time);
/// Block means from time - spread to time + spread.
void spread(Record& r, double spread);
/// An interval of the error over seeds.
void noisy(Record& r, double low, double high);

}  // namespace report
