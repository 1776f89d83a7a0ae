#include "reports/stability_record.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {

/// A tolerance that everything meets is none: as from four sigma of no draws.
bool isTolerance(double tolerance) { return std::isfinite(tolerance) && tolerance >= 0; }

/// Not a number exceeds everything: it is what was found where nothing was compared.
bool exceeds(const StabilityPoint& p) { return !(p.value <= p.tolerance) || !isTolerance(p.tolerance); }

}  // namespace

std::string_view verdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::Pass:
      return "PASS";
    case Verdict::Expected:
      return "EXPECTED";
    case Verdict::Fail:
      return "FAIL";
    case Verdict::Skipped:
      return "skipped";
  }
  return "";
}

std::string StabilityRecord::name() const {
  const std::string own = id + "/" + technique + "/" + backend;
  if (scene.empty()) return own;
  return own + "/" + scene + "/" + std::to_string(width) + "x" + std::to_string(height);
}

std::string caseLabel(const StabilityRecord& record, const std::vector<StabilityRecord>& records) {
  const bool several = std::ranges::any_of(
      records, [&](const StabilityRecord& r) { return r.scene != records.front().scene; });
  return several && !record.scene.empty() ? record.id + " " + record.scene : record.id;
}

const StabilityPoint* StabilityRecord::worst() const {
  const StabilityPoint* worst = nullptr;
  const auto excess = [](const StabilityPoint& p) {
    return std::isnan(p.value) || !isTolerance(p.tolerance) ? INFINITY : p.value - p.tolerance;
  };
  for (const StabilityPoint& p : curve)
    if (!worst || excess(p) > excess(*worst)) worst = &p;
  return worst;
}

void judge(StabilityRecord& record, const std::string& expected) {
  record.breaksAt.reset();
  std::string defect;  // of the case itself, which no error by construction excuses
  for (const StabilityPoint& p : record.curve) {
    if (std::isnan(p.value)) defect = "nothing was compared, or the result is not a number";
    if (!isTolerance(p.tolerance)) defect = "the tolerance is not finite: nothing could exceed it";
  }
  for (const StabilityPoint& p : record.curve)
    if (exceeds(p)) {
      record.breaksAt = p.x;
      break;
    }
  record.verdict = !record.breaksAt    ? Verdict::Pass
                   : !expected.empty() ? Verdict::Expected
                                       : Verdict::Fail;
  record.why = record.verdict == Verdict::Pass       ? ""
               : record.verdict == Verdict::Expected ? expected
                                                     : "beyond the tolerance";
  if (!defect.empty()) {
    record.verdict = Verdict::Fail;
    record.why = defect;
  }
  if (record.curve.empty()) {
    record.verdict = Verdict::Skipped;
    record.why = "nothing to compare";
  }
}

}  // namespace report
