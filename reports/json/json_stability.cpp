#include "reports/json/json_stability.h"

#include <limits>

#include "reports/json/json_cell.h"

namespace report {
namespace {

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

Json stabilityToJson(const StabilityRecord& r) {
  Json out = {{"name", r.name()},
              {"case", r.id},
              {"title", r.title},
              {"property", r.property},
              {"reason", r.reason},
              {"technique", r.technique},
              {"role", roleName(r.role)},
              {"backend", r.backend},
              {"scene", r.scene.empty() ? Json(nullptr) : Json(r.scene)},
              {"parameter", r.parameter},
              {"logarithmic", r.logarithmic},
              {"verdict", verdictName(r.verdict)},
              {"why", r.why},
              {"breaks_at", r.breaksAt ? Json(*r.breaksAt) : Json(nullptr)},
              {"curve", Json::array()}};
  if (r.scene.empty()) {
    for (const std::string key : {"scene", "width", "height"}) {
      out[key] = nullptr;
      out[key + "_why"] = "the case has its own";
    }
  } else {
    out["width"] = r.width;
    out["height"] = r.height;
  }
  for (const StabilityPoint& p : r.curve)
    out["curve"].push_back({{"x", p.x}, {"value", finite(p.value)}, {"tolerance", p.tolerance}});
  return out;
}

StabilityRecord readStability(const Field& f) {
  StabilityRecord r{.id = f.at("case").text(),
                    .title = f.at("title").text(),
                    .property = f.at("property").text(),
                    .reason = f.at("reason").text(),
                    .technique = f.at("technique").text(),
                    .backend = f.at("backend").text(),
                    .parameter = f.at("parameter").text(),
                    .logarithmic = f.at("logarithmic").boolean()};
  if (const auto role = f.find("role")) r.role = readRole(*role);
  if (const auto scene = f.find("scene")) {
    r.scene = scene->text();
    r.width = f.at("width").integer<uint32_t>();
    r.height = f.at("height").integer<uint32_t>();
  }
  for (const Field& point : f.at("curve").items()) {
    const auto value = point.find("value");
    r.curve.push_back({.x = point.at("x").number(),
                       .value = value ? value->number() : std::numeric_limits<double>::quiet_NaN(),
                       .tolerance = point.at("tolerance").number()});
  }
  if (const auto at = f.find("breaks_at")) r.breaksAt = at->number();
  r.why = f.at("why").text();
  const Field verdict = f.at("verdict");
  for (const Verdict v : {Verdict::Pass, Verdict::Expected, Verdict::Fail, Verdict::Skipped})
    if (verdict.text() == verdictName(v)) {
      r.verdict = v;
      return r;
    }
  verdict.refuse("\"PASS\", \"EXPECTED\", \"FAIL\" or \"skipped\"");
}

}  // namespace report
