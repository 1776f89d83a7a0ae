#include "reports/json/json_error.h"

#include "reports/record_view.h"

namespace report {
namespace {

Json toJson(const ErrorStats& e) {
  return {{"rmse", e.rmse},         {"bias", e.bias},        {"max", e.max},
          {"p999", e.p999},         {"over_1_255", e.over1}, {"rmse_rgb", e.rmseRgb},
          {"bias_rgb", e.biasRgb}, {"pixels", e.pixels}};
}

Json toJson(const VisibilityError& e) {
  const auto orNull = [](const std::optional<double>& v) { return v ? Json(*v) : Json(nullptr); };
  Json out = toJson(e.all);
  out["weighted_rmse"] = orNull(e.weighted);
  out["one_sided"] = e.oneSided;
  out["interior"] = toJson(e.interior);
  out["interior"]["weighted_rmse"] = orNull(e.weightedInterior);
  out["interior"]["one_sided"] = e.oneSidedInterior;
  return out;
}

Json toJson(const ImageError& e) {
  Json out = toJson(e.all);
  out["relmse"] = e.relmse;
  out["flip"] = e.flip;
  out["interior"] = toJson(e.interior);
  out["interior"]["relmse"] = e.relmseInterior;
  out["interior"]["flip"] = e.flipInterior;
  return out;
}

Json toJson(const NoiseRecord& n) {
  return {{"seeds", n.seeds},       {"noise", n.noise},        {"bias_rmse", n.biasRmse},
          {"bias", n.bias},         {"bias_low", n.biasLow},   {"bias_high", n.biasHigh},
          {"rmse_low", n.rmseLow}, {"rmse_high", n.rmseHigh}};
}

Json toJson(const Certificate& c) {
  Json out = {{"unbiased", c.unbiased ? Json(*c.unbiased) : Json(nullptr)},
              {"test", c.test},
              {"family_wise_error", c.familyWiseError},
              {"detectable", c.detectable},
              {"informative", c.informative},
              {"regions", Json::array()}};
  if (!c.unbiased) out["unbiased_why"] = c.why;
  for (const RegionTest& t : c.regions)
    out["regions"].push_back({{"light", t.light},
                              {"layer", t.layer},
                              {"channel", t.channel},
                              {"x", t.x},
                              {"y", t.y},
                              {"pixels", t.pixels},
                              {"q", t.q},
                              {"trials", t.trials},
                              {"passes", t.passes},
                              {"mean", t.mean},
                              {"error", t.error},
                              {"p_value", t.pValue}});
  return out;
}

Json toJson(const Blame& b) {
  Json out = {{"mse", b.mse}, {"shares", Json::object()}};
  for (const auto& [cause, share] : b.shares) out["shares"][cause] = share;
  return out;
}

template <class T>
void put(Json& out, const Record& r, const std::string& key, const std::optional<T>& value) {
  out[key] = value ? toJson(*value) : Json(nullptr);
  putWhy(out, r, key, !value);
}

}  // namespace

void putWhy(Json& out, const Record& r, const std::string& key, bool absent) {
  if (auto why = r.why.find(key); absent && why != r.why.end()) out[key + "_why"] = why->second;
}

void putErrors(Json& out, const Record& r) {
  put(out, r, "visibility", r.visibility);
  out["visibility_layers"] = Json::array();
  for (const LayerError& l : r.visibilityLayers) {
    Json layer = {{"light", l.light}, {"light_name", l.lightName}, {"layer", l.layer}};
    layer.update(toJson(l.error));
    out["visibility_layers"].push_back(std::move(layer));
  }
  out["visibility_regions"] = Json::array();
  for (const RegionError& e : r.visibilityRegions) {
    Json region = {{"region", e.region}, {"share", e.share}, {"rmse", e.rmse}, {"bias", e.bias}};
    region["noise"] = e.noise ? Json(*e.noise) : Json(nullptr);
    putWhy(region, r, "noise", !e.noise);
    out["visibility_regions"].push_back(std::move(region));
  }
  put(out, r, "image", r.image);
  put(out, r, "noise", r.noise);
  put(out, r, "certificate", r.certificate);
  put(out, r, "blame", r.blame);
  out["truth_stderr"] = r.truthStderr ? Json(*r.truthStderr) : Json(nullptr);
  putWhy(out, r, "truth_stderr", !r.truthStderr);
  out["below_truth"] = r.visibility ? Json(belowTruth(r)) : Json(nullptr);
  if (!r.visibility) out["below_truth_why"] = whyOf(r, "visibility");
}

}  // namespace report
