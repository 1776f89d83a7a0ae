// Runs hard cases for techniques on backends: the suite `stability`.
#pragma once

#include <optional>

#include "suites/stability/case.h"

namespace sb {

/// One case of one technique on one backend, as plain data.
struct StabilityJob {
  std::string caseId;
  std::string technique;  ///< shadow technique
  std::string transparency;
  std::string lights = kDefaultLights;
  std::string backend;
  std::map<std::string, std::string> knobs = {};  ///< variant of the technique
  uint32_t seeds = 1;  ///< over which stochastic techniques are averaged
  std::string scene = "";  ///< of the user's, as makeScene() takes it; "": the case has its own
  rhi::Extent2D size = {96, 64};  ///< of that scene's pictures
  bool quick = false;  ///< fewer and smaller points
};

/// "G1/CSSM2/vulkan", "G1/CSSM2/format:rgba16/vulkan", "G1/CSSM2/vulkan/a.glb/96x64": what --filter
/// matches and --list prints.
std::string jobName(const StabilityJob& job);

/// What to ask: empty lists mean all.
struct StabilitySelection {
  /// TECHNIQUE[+TRANSPARENCY][@LIGHTS]; all: shadows with the default transparency and loop over
  /// lights; the others of these without shadows.
  std::vector<std::string> techniques;
  std::vector<std::string> cases;  ///< ids
  std::vector<std::string> backends;
  std::string filter;  ///< a regular expression over names
  /// Knobs of each variant to ask; a technique that lacks one of the knobs is not asked for it.
  std::vector<std::map<std::string, std::string>> variants = {{}};
  uint32_t seeds = 1;
  /// Scenes that the generic properties are asked of, instead of every case's own.
  std::vector<std::string> scenes = {};
  std::optional<rhi::Extent2D> size = {};  ///< of their pictures
  bool quick = false;                      ///< fewer and smaller points of every case
};

/// Every case of every technique that it asks something of. Throws InputError with the nearest
/// names.
std::vector<StabilityJob> stabilityJobs(const StabilitySelection& selection);

/// Runs one, on a device of the job's backend; `other`: of another API, or null. What the device
/// declares that it lacks, or has no memory for, gives a record that is skipped with the reason; any
/// other refusal is a failure. Throws rhi::Error when the device is lost. `scene`: the job's, where it
/// names one; null: it is made anew.
report::StabilityRecord runStability(const StabilityJob& job, const DeviceContext& device,
                                     const DeviceContext* other, const Scene* scene = nullptr);
/// The record of a job that could not be run to its end.
report::StabilityRecord failedStability(const StabilityJob& job, const std::string& why);
/// The same for a backend that does not start.
report::StabilityRecord skippedStability(const StabilityJob& job, const std::string& why);

}  // namespace sb
