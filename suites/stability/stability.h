// Runs hard cases for techniques on backends: the suite `stability`.
#pragma once

#include "suites/stability/case.h"

namespace sb {

/// One case of one technique on one backend, as plain data.
struct StabilityJob {
  std::string caseId;
  std::string technique;  ///< shadow technique
  std::string transparency;
  std::string backend;
};

/// "G1/CSSM2/vulkan": what --filter matches and --list prints.
std::string jobName(const StabilityJob& job);

/// Every case of every technique that it asks something of. `techniques`: TECHNIQUE[+TRANSPARENCY];
/// none: all of them, shadows with the default transparency, transparency without shadows. `cases`:
/// ids; none: all. `filter`: a regular expression over names. Throws InputError with the nearest
/// names.
std::vector<StabilityJob> stabilityJobs(const std::vector<std::string>& techniques,
                                        const std::vector<std::string>& cases,
                                        const std::vector<std::string>& backends,
                                        const std::string& filter);

/// Runs one, on a device of the job's backend; `other`: of another API, or null. What the device
/// refuses gives a record that is skipped with the reason. `quick`: fewer and smaller points.
report::StabilityRecord runStability(const StabilityJob& job, const DeviceContext& device,
                                     const DeviceContext* other, bool quick);
/// The same for a backend that does not start.
report::StabilityRecord skippedStability(const StabilityJob& job, const std::string& why);

}  // namespace sb
