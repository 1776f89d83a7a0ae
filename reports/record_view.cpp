#include "reports/record_view.h"

#include <algorithm>

namespace report {

std::string techniqueOf(const Record& r) {
  const std::string full = r.technique + "+" + r.transparency;
  return r.name.starts_with(full + "/") ? full : r.technique;
}

std::string variantOf(const Record& r) {
  // TECHNIQUE/backend/scene[/knob:value...]/WxH; a scene may hold slashes itself.
  const std::string head = techniqueOf(r) + "/" + r.backend + "/" + r.scene + "/";
  if (!r.name.starts_with(head)) return "";
  std::string rest = r.name.substr(head.size());
  const size_t size = rest.rfind('/');
  if (size == std::string::npos) return "";
  rest.resize(size);
  std::ranges::replace(rest, '/', ' ');
  return rest;
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
