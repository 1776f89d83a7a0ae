#include "suites/harness/checks/compare.h"

#include <algorithm>

#include "reports/stats/stats.h"
#include "suites/harness/checks/verify.h"

namespace sb {
namespace {

using report::Record;

bool isOk(const Measured& m) { return m.result->record.status == report::Status::Ok; }

bool isSameOnOtherBackend(const CellId& a, const CellId& b) {
  return a.backend != b.backend && onAnyBackend(a) == onAnyBackend(b);
}

void comparePictures(Record& record, const report::Picture& mine, const report::Picture& other) {
  const float exposure = float(record.exposure);
  record.crossBackendMax255 =
      std::max(record.crossBackendMax255.value_or(0), maxDifference255(mine, other, exposure));
  record.crossBackendOver1 =
      std::max(record.crossBackendOver1.value_or(0), pixelsBeyondOneStep(mine, other, exposure));
}

/// Is `b` what the cost of `a` is told against? The reference, which runs on no backend, has the
/// first one that is compared by CPU time as it is.
bool isBaseline(const Measured& a, const Measured& b, const Record& record) {
  if (!isReference(a.result->id)) return b.result->id == baselineOf(a.result->id);
  return roleOf(b.result->id) == report::Role::Baseline && b.software && record.ratios.empty();
}

report::Ratio ratioOf(const Measured& a, const Measured& b) {
  const bool software = a.software && b.software;
  std::vector<double> mine = blockMeans(*a.samples, software);
  std::vector<double> other = blockMeans(*b.samples, software);
  // Blocks of one number ran side by side; a slow cell, or an interruption, leaves some without.
  const size_t pairs = std::min(mine.size(), other.size());
  mine.resize(pairs);
  other.resize(pairs);
  report::Ratio ratio = report::pairedRatio(mine, other);
  ratio.kind = isSameOnOtherBackend(a.result->id, b.result->id) ? "backend" : "baseline";
  ratio.against = b.result->record.name;
  ratio.of = software ? "cpu_ms" : "frame_ms";
  return ratio;
}

void explainAbsence(Record& record) {
  if (record.ratios.empty() && !record.why.contains("ratios"))
    record.why["ratios"] = "nothing to compare with was measured beside this cell";
  if (record.crossBackendMax255) return;
  for (const char* key : {"cross_backend_max_255", "cross_backend_over_1_255"})
    record.why[key] = "no other backend ran this cell";
}

}  // namespace

void compareCells(std::span<const Measured> cells) {
  for (const Measured& a : cells) {
    Record& record = a.result->record;
    if (!isOk(a)) continue;
    for (const Measured& b : cells) {
      if (&a == &b || !isOk(b)) continue;
      const bool other = isSameOnOtherBackend(a.result->id, b.result->id);
      if (other) comparePictures(record, a.result->picture, b.result->picture);
      if (!other && !isBaseline(a, b, record)) continue;
      if (!record.contamination.empty())
        record.why["ratios"] = "contaminated: " + record.contamination.front();
      else if (!b.result->record.contamination.empty())
        record.why["ratios"] =
            b.result->record.name + " is contaminated: " + b.result->record.contamination.front();
      else
        record.ratios.push_back(ratioOf(a, b));
    }
    explainAbsence(record);
  }
}

}  // namespace sb
