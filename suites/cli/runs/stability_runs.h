// The hard cases of a suite, from the command line.
#pragma once

#include <atomic>
#include <functional>

#include "suites/cli/options/options.h"
#include "suites/harness/devices.h"
#include "suites/harness/suite/suite.h"
#include "suites/stability/stability.h"

namespace sb {

/// Jobs of all [[stability]] tables. Throws InputError with file, line and field.
std::vector<StabilityJob> stabilityJobs(const Suite& suite, const Selection& over,
                                        const std::vector<std::string>& defaultBackends);

/// Runs jobs until interrupted; `progress` before each, `finished` after it.
void runStability(
    const std::vector<StabilityJob>& jobs, Devices& devices, const std::atomic<bool>& interrupted,
    const std::function<void(const StabilityJob& next, size_t done)>& progress,
    const std::function<void(const StabilityJob&, const report::StabilityRecord&)>& finished);

}  // namespace sb
