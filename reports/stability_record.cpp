#include "reports/stability_record.h"

#include <cmath>

namespace report {
namespace {

/// Not a number exceeds everything.
bool exceeds(const StabilityPoint& p) { return !(p.value <= p.tolerance); }

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

const StabilityPoint* StabilityRecord::worst() const {
  const StabilityPoint* worst = nullptr;
  const auto excess = [](const StabilityPoint& p) {
    return std::isnan(p.value) ? INFINITY : p.value - p.tolerance;
  };
  for (const StabilityPoint& p : curve)
    if (!worst || excess(p) > excess(*worst)) worst = &p;
  return worst;
}

void judge(StabilityRecord& record, const std::string& expected) {
  record.breaksAt.reset();
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
  if (record.curve.empty()) {
    record.verdict = Verdict::Skipped;
    record.why = "nothing to compare";
  }
}

}  // namespace report
