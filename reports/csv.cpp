#include "reports/csv.h"

#include <cstdio>
#include <functional>
#include <type_traits>

#include "base/number.h"
#include "base/text.h"
#include "reports/record_view.h"

namespace report {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

/// Tables compute what begins like a formula: a text that does stands behind an apostrophe.
/// Numbers stay as they are.
std::string quoted(const std::string& raw) {
  std::string text = raw;
  for (char& c : text)
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';  // a row is a line
  text = base::printable(text);
  const bool formula = !text.empty() && std::string_view("=+-@").find(text[0]) != text.npos &&
                       !base::readNumber(text, {});
  if (formula) text.insert(text.begin(), '\'');
  if (!formula && text.find_first_of(",\"") == std::string::npos) return text;
  std::string out = "\"";
  for (char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string joined(const std::vector<std::string>& parts) {
  std::string out;
  for (const std::string& p : parts) out += (out.empty() ? "" : ";") + p;
  return out;
}

struct Column {
  std::string name;
  std::function<std::string(const Record&)> value;
};

template <class T>
std::string optionalNumber(const std::optional<T>& value) {
  if (!value) return "";
  if constexpr (std::is_integral_v<T>)
    return std::to_string(*value);
  else
    return number(double(*value));
}

/// Counts of cells that did not run are unknown, not zero.
std::string countOf(const Record& r, uint64_t count) {
  return r.status == Status::Ok ? std::to_string(count) : "";
}

void addRatio(std::vector<Column>& columns, const std::string& kind) {
  auto add = [&](const char* part, auto pick) {
    columns.push_back({"ratio_" + kind + part, [kind, pick](const Record& r) {
                         for (const Ratio& x : r.ratios)
                           if (x.kind == kind) return std::string(pick(x));
                         return std::string();
                       }});
  };
  add("", [](const Ratio& x) { return number(x.value); });
  add("_low", [](const Ratio& x) { return number(x.low); });
  add("_high", [](const Ratio& x) { return number(x.high); });
  add("_against", [](const Ratio& x) { return x.against; });
}

std::string passesText(const Record& r) {
  std::vector<std::string> parts;
  for (const PassRecord& p : r.passes) parts.push_back(p.label + ":" + number(p.ms));
  return joined(parts);
}

void addDistribution(std::vector<Column>& columns, const std::string& name,
                     std::optional<Distribution> Record::*member) {
  auto add = [&](const char* part, auto pick) {
    columns.push_back({name + "_" + part, [member, pick](const Record& r) {
                         return r.*member ? number(double(pick(*(r.*member)))) : std::string();
                       }});
  };
  add("median", [](const Distribution& d) { return d.median; });
  add("q1", [](const Distribution& d) { return d.q1; });
  add("q3", [](const Distribution& d) { return d.q3; });
  add("cv", [](const Distribution& d) { return d.cv; });
  add("n", [](const Distribution& d) { return d.n; });
  add("p95", [](const Distribution& d) { return d.p95; });
  add("p99", [](const Distribution& d) { return d.p99; });
}

void addError(std::vector<Column>& columns, const std::string& name,
              const std::function<const ErrorStats*(const Record&)>& get) {
  auto add = [&](const char* part, auto pick) {
    columns.push_back({name + "_" + part, [get, pick](const Record& r) {
                         const ErrorStats* e = get(r);
                         return e ? number(pick(*e)) : std::string();
                       }});
  };
  add("rmse", [](const ErrorStats& e) { return e.rmse; });
  add("bias", [](const ErrorStats& e) { return e.bias; });
  add("max", [](const ErrorStats& e) { return e.max; });
  add("p999", [](const ErrorStats& e) { return e.p999; });
  add("over_1_255", [](const ErrorStats& e) { return e.over1; });
}

void addRegion(std::vector<Column>& columns, const std::string& region) {
  auto add = [&](const char* part, auto pick) {
    columns.push_back({"visibility_regions_" + region + "_" + part, [region, pick](const Record& r) {
                         for (const RegionError& e : r.visibilityRegions)
                           if (e.region == region) return optionalNumber(pick(e));
                         return std::string();
                       }});
  };
  add("share", [](const RegionError& e) { return std::optional(e.share); });
  add("rmse", [](const RegionError& e) { return std::optional(e.rmse); });
  add("bias", [](const RegionError& e) { return std::optional(e.bias); });
  add("noise", [](const RegionError& e) { return e.noise; });
}

void addErrors(std::vector<Column>& c) {
  c.push_back({"visibility_weighted_rmse", [](const Record& r) {
                 return r.visibility ? optionalNumber(r.visibility->weighted) : std::string();
               }});
  addError(c, "visibility", [](const Record& r) { return r.visibility ? &r.visibility->all : nullptr; });
  addError(c, "visibility_interior",
           [](const Record& r) { return r.visibility ? &r.visibility->interior : nullptr; });
  c.push_back({"visibility_one_sided", [](const Record& r) {
                 return r.visibility ? std::to_string(r.visibility->oneSided) : std::string();
               }});
  c.push_back({"visibility_interior_one_sided", [](const Record& r) {
                 return r.visibility ? std::to_string(r.visibility->oneSidedInterior)
                                     : std::string();
               }});
  for (const char* region : {"dark", "saturated", "pale", "lit"}) addRegion(c, region);
  addError(c, "image", [](const Record& r) { return r.image ? &r.image->all : nullptr; });
  addError(c, "image_interior",
           [](const Record& r) { return r.image ? &r.image->interior : nullptr; });
  auto add = [&](const char* name, auto value) { c.push_back({name, value}); };
  add("exposure", [](const Record& r) { return number(r.exposure); });
  add("image_relmse", [](const Record& r) { return r.image ? number(r.image->relmse) : ""; });
  add("image_flip", [](const Record& r) { return r.image ? number(r.image->flip) : ""; });
  add("noise", [](const Record& r) { return r.noise ? number(r.noise->noise) : ""; });
  add("noise_bias_rmse", [](const Record& r) { return r.noise ? number(r.noise->biasRmse) : ""; });
  add("noise_seeds", [](const Record& r) { return r.noise ? std::to_string(r.noise->seeds) : ""; });
  add("noise_bias", [](const Record& r) { return r.noise ? number(r.noise->bias) : ""; });
  add("noise_bias_low", [](const Record& r) { return r.noise ? number(r.noise->biasLow) : ""; });
  add("noise_bias_high", [](const Record& r) { return r.noise ? number(r.noise->biasHigh) : ""; });
  add("certificate", [](const Record& r) {
    return std::string(r.certificate ? certificateVerdict(*r.certificate) : "");
  });
  add("certificate_why", [](const Record& r) {
    return r.certificate ? r.certificate->why : std::string();
  });
  add("blame", [](const Record& r) {
    std::vector<std::string> parts;
    if (r.blame)
      for (const auto& [cause, share] : r.blame->shares) parts.push_back(cause + ":" + number(share));
    return joined(parts);
  });
  add("truth_stderr", [](const Record& r) { return optionalNumber(r.truthStderr); });
  add("below_truth", [](const Record& r) {
    return std::string(!r.visibility ? "" : belowTruth(r) ? "true" : "false");
  });
}

std::string knobText(const Record& r) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : r.knobs) parts.push_back(name + ":" + value);
  return joined(parts);
}

std::string changedText(const Record& r) {
  std::vector<std::string> parts;
  for (const auto& [knob, value] : r.id.knobs) parts.push_back(knob);
  return joined(parts);
}

std::string skippedText(const Record& r) {
  std::vector<std::string> parts;
  for (const auto& [effect, why] : r.effectsSkipped) parts.push_back(effect);
  return joined(parts);
}

std::vector<Column> makeColumns() {
  std::vector<Column> c;
  auto add = [&](const char* name, auto value) { c.push_back({name, value}); };
  add("name", [](const Record& r) { return r.name; });
  add("technique", [](const Record& r) { return r.id.technique; });
  add("transparency", [](const Record& r) { return r.id.transparency; });
  add("lights", [](const Record& r) { return r.id.lights; });
  add("role", [](const Record& r) { return std::string(roleName(r.role)); });
  add("backend", [](const Record& r) { return r.id.backend; });
  add("device", [](const Record& r) { return r.device; });
  add("device_type", [](const Record& r) { return r.deviceType; });
  add("driver", [](const Record& r) { return r.driver; });
  add("scene", [](const Record& r) { return r.id.scene; });
  add("scene_hash", [](const Record& r) { return r.sceneHash; });
  add("width", [](const Record& r) { return std::to_string(r.id.width); });
  add("height", [](const Record& r) { return std::to_string(r.id.height); });
  add("knobs", knobText);
  add("knobs_changed", changedText);
  add("seed", [](const Record& r) { return std::to_string(r.id.seed); });
  add("version", [](const Record& r) { return r.version; });
  add("effects_planned", [](const Record& r) { return joined(r.effectsPlanned); });
  add("effects_skipped", skippedText);
  add("effects_unrepresented", [](const Record& r) { return joined(r.effectsUnrepresented); });
  add("time_source", [](const Record& r) { return r.timeSource; });
  addDistribution(c, "frame_ms", &Record::frame);
  addDistribution(c, "wall_ms", &Record::wall);
  addDistribution(c, "cpu_ms", &Record::cpu);
  addDistribution(c, "record_ms", &Record::record);
  addDistribution(c, "device_ms", &Record::device_);
  add("submit_ms", [](const Record& r) { return optionalNumber(r.submitMs); });
  add("compile_ms", [](const Record& r) { return optionalNumber(r.compileMs); });
  add("shadow_ms", [](const Record& r) { return optionalNumber(r.shadowMs); });
  add("scene_ms", [](const Record& r) { return optionalNumber(r.sceneMs); });
  add("combined_ms", [](const Record& r) { return optionalNumber(r.combinedMs); });
  add("stamped_frame_ms", [](const Record& r) { return optionalNumber(r.stampedFrameMs); });
  add("passes", passesText);
  addRatio(c, "baseline");
  addRatio(c, "backend");
  add("stopped_by", [](const Record& r) { return r.stoppedBy; });
  add("precision", [](const Record& r) { return optionalNumber(r.precision); });
  add("pass_count", [](const Record& r) { return countOf(r, r.passCount); });
  add("draw_count", [](const Record& r) { return countOf(r, r.drawCount); });
  add("triangle_count", [](const Record& r) { return countOf(r, r.triangleCount); });
  add("bytes", [](const Record& r) { return countOf(r, r.bytes); });
  addErrors(c);
  add("nonfinite", [](const Record& r) { return optionalNumber(r.nonfinite); });
  add("stable", [](const Record& r) {
    return std::string(!r.stable ? "" : *r.stable ? "true" : "false");
  });
  add("cross_backend_max_255",
      [](const Record& r) { return optionalNumber(r.crossBackendMax255); });
  add("cross_backend_over_1_255",
      [](const Record& r) { return optionalNumber(r.crossBackendOver1); });
  add("picture", [](const Record& r) { return r.picture; });
  add("status", [](const Record& r) { return std::string(statusName(r.status)); });
  add("reason", [](const Record& r) { return r.reason; });
  add("warnings", [](const Record& r) { return joined(r.warnings); });
  add("contamination", [](const Record& r) { return joined(r.contamination); });
  add("command", [](const Record& r) { return r.command; });
  return c;
}

}  // namespace

std::string toCsv(const Run& run) {
  static const std::vector<Column> columns = makeColumns();
  std::string out;
  for (size_t i = 0; i < columns.size(); ++i) out += (i ? "," : "") + columns[i].name;
  out += ",run_interrupted\n";
  for (const Record& r : run.records) {
    for (size_t i = 0; i < columns.size(); ++i) out += (i ? "," : "") + quoted(columns[i].value(r));
    out += run.interrupted ? ",true\n" : ",false\n";
  }
  return out;
}

}  // namespace report
