// Cells made by hand for tests of trade-offs.
#pragma once

#include <string>

#include "reports/record.h"
#include "reports/stats/tradeoff.h"

namespace report {

/// On a software device: its CPU time compares. No blocks, so the time's interval is a point.
Record cell(const std::string& technique, double time, double error, const std::string& size = "");
/// The tracer's cell, error 0, on the same scene.
Record tracer(double time);
/// Block means from time - spread to time + spread.
void spread(Record& r, double spread);
/// An interval of the error over seeds.
void noisy(Record& r, double low, double high);

}  // namespace report
