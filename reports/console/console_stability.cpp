#include "reports/console/console_stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace report {
namespace {

/// One word for all APIs of a technique: the worst, with how many share it when not all do.
std::string summary(const std::vector<const StabilityRecord*>& of) {
  const auto rank = [](Verdict v) {
    return v == Verdict::Fail ? 3 : v == Verdict::Expected ? 2 : v == Verdict::Pass ? 1 : 0;
  };
  const StabilityRecord* worst =
      *std::ranges::max_element(of, {}, [&](const StabilityRecord* r) { return rank(r->verdict); });
  const auto same = std::ranges::count(of, worst->verdict, &StabilityRecord::verdict);
  std::string text =
      worst->verdict == Verdict::Skipped ? "-" : std::string(verdictName(worst->verdict));
  if (same != std::ssize(of)) text += fmt::format(" {}/{}", same, of.size());
  return text;
}

template <class T>
void addOnce(std::vector<T>& list, const T& value) {
  if (std::ranges::find(list, value) == list.end()) list.push_back(value);
}

std::string detail(const StabilityRecord& r) {
  std::string out = fmt::format("{:<8}  {}: {}\n", verdictName(r.verdict), r.name(), r.property);
  if (const StabilityPoint* p = r.worst()) {
    out += fmt::format("          found {:.3g}, allowed {:.3g}", p->value, p->tolerance);
    if (!r.parameter.empty()) out += fmt::format(" at {} = {:g}", r.parameter, p->x);
    if (r.breaksAt && !r.parameter.empty()) out += fmt::format("; breaks at {:g}", *r.breaksAt);
    out += "\n";
  }
  return out + fmt::format("          {}\n", r.why);
}

}  // namespace

std::string toTable(const std::vector<StabilityRecord>& records) {
  if (records.empty()) return "";
  std::vector<std::string> techniques, cases;
  std::map<std::pair<std::string, std::string>, std::vector<const StabilityRecord*>> cells;
  for (const StabilityRecord& r : records) {
    addOnce(techniques, r.technique);
    const std::string label = caseLabel(r, records);
    addOnce(cases, label);
    cells[{label, r.technique}].push_back(&r);
  }
  std::vector<std::vector<std::string>> rows = {{"hard case"}};
  rows.front().insert(rows.front().end(), techniques.begin(), techniques.end());
  for (const std::string& id : cases) {
    rows.push_back({id});
    for (const std::string& technique : techniques) {
      const auto it = cells.find({id, technique});
      rows.back().push_back(it == cells.end() ? "" : summary(it->second));
    }
  }
  std::vector<size_t> widths(techniques.size() + 1);
  for (const auto& row : rows)
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string out;
  for (const auto& row : rows) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}", row[i], widths[i] + 2);
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  size_t pass = 0, expected = 0, fail = 0, skipped = 0;
  for (const StabilityRecord& r : records)
    ++(r.verdict == Verdict::Pass       ? pass
       : r.verdict == Verdict::Expected ? expected
       : r.verdict == Verdict::Fail     ? fail
                                        : skipped);
  out += fmt::format(
      "{} hard cases: {} pass, {} break as expected by construction, {} fail, {} skipped\n",
      records.size(), pass, expected, fail, skipped);
  for (const Verdict v : {Verdict::Expected, Verdict::Fail})
    for (const StabilityRecord& r : records)
      if (r.verdict == v) out += detail(r);
  return out;
}

}  // namespace report
