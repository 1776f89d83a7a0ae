#include "reports/record_view.h"

namespace report {

std::string techniqueOf(const Record& r) { return techniqueName(r.id); }

std::string variantOf(const CellId& id) {
  std::string text;
  for (const auto& [knob, value] : id.knobs) text += (text.empty() ? "" : " ") + knob + ":" + value;
  if (id.seed != 0) text += (text.empty() ? "seed:" : " seed:") + std::to_string(id.seed);
  return text;
}

std::string timeKeyOf(const Record& r) {
  if (r.timeSource.empty()) return "";
  return r.timeSource == "software" ? "cpu_ms" : "frame_ms";
}

const std::optional<Distribution>& comparedTime(const Record& r) {
  return timeKeyOf(r) == "cpu_ms" ? r.cpu : r.frame;
}

bool belowTruth(const Record& r) {
  return r.visibility && r.visibility->all.rmse < 3 * r.truthStderr.value_or(0);
}

std::string whyOf(const Record& r, const std::string& key) {
  const auto found = r.why.find(key);
  return found == r.why.end() ? "" : found->second;
}

}  // namespace report
