// One property of a technique in a dangerous configuration, measured (spec 17): what was found,
// what is allowed and why, and where it breaks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/cell_id.h"

namespace report {

enum class Verdict : uint8_t {
  Pass,
  Expected,  ///< beyond the tolerance, by an error that the technique has by construction: `why`
  Fail,
  Skipped,  ///< could not be run here: `why`
};
std::string_view verdictName(Verdict verdict);  ///< "PASS", "EXPECTED", "FAIL", "skipped"

struct StabilityPoint {
  double x = 0;      ///< the dangerous parameter
  double value = 0;  ///< what was found there
  double tolerance = 0;
};

struct StabilityRecord {
  std::string id;         ///< of the case: "G1"
  std::string title;      ///< what is done to the technique
  std::string property;   ///< what must hold, with the unit of `value`
  std::string reason;     ///< of the tolerance
  std::string technique;  ///< TECHNIQUE[+TRANSPARENCY][@LIGHTS][/knob:value...]
  /// Baseline: nothing but what lacks shadows, which is asked what concerns every technique.
  Role role = Role::Technique;
  std::string backend;
  std::string scene;  ///< the user's, which the property was asked of; "": the case has its own
  uint32_t width = 0, height = 0;  ///< of its picture
  std::string parameter;     ///< of the curve, with its unit; "": one configuration
  bool logarithmic = false;  ///< the parameter spans magnitudes
  std::vector<StabilityPoint> curve;
  std::optional<double> breaksAt;  ///< first parameter beyond the tolerance
  Verdict verdict = Verdict::Pass;
  std::string why;  ///< of every verdict but Pass

  /// "G1/CSSM2/vulkan", "G1/CSSM2/vulkan/scene.glb/96x64".
  std::string name() const;
  /// The point that exceeds its tolerance most, or comes nearest to it. Null without points.
  const StabilityPoint* worst() const;
};

/// How a case is told from others of the run: by its id, and by the scene where `records` are of
/// several.
std::string caseLabel(const StabilityRecord& record, const std::vector<StabilityRecord>& records);

/// Verdict and breaking point from the curve. `expected`: what error by construction excuses points
/// beyond their tolerance; empty: none does.
void judge(StabilityRecord& record, const std::string& expected);

}  // namespace report
