// A run made by hand: a good cell, one whose backends differ and that is contaminated, one skipped,
// one failed.
#pragma once

#include "reports/record.h"

namespace report {

Run sampleRun();

}  // namespace report
