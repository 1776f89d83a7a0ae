#include "reports/json/json_read_error.h"

namespace report {
namespace {

std::array<double, 3> readRgb(const Field& field) {
  const std::vector<Field> items = field.items();
  if (items.size() != 3) field.refuse("three numbers");
  return {items[0].number(), items[1].number(), items[2].number()};
}

ErrorStats readStats(const Field& f) {
  return {.rmse = f.at("rmse").number(),
          .bias = f.at("bias").number(),
          .max = f.at("max").number(),
          .p999 = f.at("p999").number(),
          .over1 = f.at("over_1_255").number(),
          .rmseRgb = readRgb(f.at("rmse_rgb")),
          .biasRgb = readRgb(f.at("bias_rgb")),
          .pixels = f.at("pixels").integer<uint64_t>()};
}

VisibilityError readVisibility(const Field& f) {
  const Field interior = f.at("interior");
  VisibilityError e{readStats(f), readStats(interior)};
  // Earlier files did not count them.
  if (const auto count = f.find("one_sided")) e.oneSided = count->integer<uint64_t>();
  if (const auto count = interior.find("one_sided")) e.oneSidedInterior = count->integer<uint64_t>();
  if (const auto w = f.find("weighted_rmse")) e.weighted = w->number();
  if (const auto w = interior.find("weighted_rmse")) e.weightedInterior = w->number();
  return e;
}

ImageError readImage(const Field& f) {
  const Field interior = f.at("interior");
  return {.all = readStats(f),
          .interior = readStats(interior),
          .relmse = f.at("relmse").number(),
          .relmseInterior = interior.at("relmse").number(),
          .flip = f.at("flip").number(),
          .flipInterior = interior.at("flip").number()};
}

NoiseRecord readNoise(const Field& f) {
  return {.seeds = f.at("seeds").integer<uint32_t>(),
          .noise = f.at("noise").number(),
          .biasRmse = f.at("bias_rmse").number(),
          .bias = f.at("bias").number(),
          .biasLow = f.at("bias_low").number(),
          .biasHigh = f.at("bias_high").number(),
          .rmseLow = f.at("rmse_low").number(),
          .rmseHigh = f.at("rmse_high").number()};
}

RegionTest readRegion(const Field& f) {
  return {.light = f.at("light").integer<uint32_t>(),
          .layer = f.at("layer").integer<uint32_t>(),
          .channel = f.at("channel").integer<uint32_t>(),
          .x = f.at("x").integer<uint32_t>(),
          .y = f.at("y").integer<uint32_t>(),
          .pixels = f.at("pixels").integer<uint64_t>(),
          .q = f.at("q").number(),
          .trials = f.at("trials").integer<uint64_t>(),
          .passes = f.at("passes").integer<uint64_t>(),
          .mean = f.at("mean").number(),
          .error = f.at("error").number(),
          .pValue = f.at("p_value").number()};
}

Certificate readCertificate(const Field& f) {
  Certificate out{.unbiased = {},
                  .why = "",
                  .test = f.at("test").text(),
                  .familyWiseError = f.at("family_wise_error").number(),
                  .detectable = f.at("detectable").number(),
                  .informative = f.at("informative").integer<uint32_t>(),
                  .regions = {}};
  if (auto unbiased = f.find("unbiased")) out.unbiased = unbiased->boolean();
  if (auto why = f.find("unbiased_why")) out.why = why->text();
  for (const Field& region : f.at("regions").items()) out.regions.push_back(readRegion(region));
  return out;
}

Blame readBlame(const Field& f) {
  Blame out{.mse = f.at("mse").number(), .shares = {}};
  for (const auto& [cause, share] : f.at("shares").members())
    out.shares.emplace_back(cause, share.number());
  return out;
}

LayerError readLayer(const Field& f) {
  return {.light = f.at("light").integer<uint32_t>(),
          .lightName = f.at("light_name").text(),
          .layer = f.at("layer").integer<uint32_t>(),
          .error = readVisibility(f)};
}

RegionError readRegionError(const Field& f) {
  RegionError out{.region = f.at("region").text(),
                  .share = f.at("share").number(),
                  .rmse = f.at("rmse").number(),
                  .bias = f.at("bias").number(),
                  .noise = {}};
  if (auto noise = f.find("noise")) out.noise = noise->number();
  return out;
}

}  // namespace

void readErrors(const Field& entry, Record& r) {
  if (auto f = entry.find("visibility")) r.visibility = readVisibility(*f);
  if (auto f = entry.find("visibility_layers"))
    for (const Field& layer : f->items()) r.visibilityLayers.push_back(readLayer(layer));
  if (auto f = entry.find("visibility_regions"))
    for (const Field& region : f->items()) r.visibilityRegions.push_back(readRegionError(region));
  if (auto f = entry.find("image")) r.image = readImage(*f);
  if (auto f = entry.find("noise")) r.noise = readNoise(*f);
  if (auto f = entry.find("certificate")) r.certificate = readCertificate(*f);
  if (auto f = entry.find("blame")) r.blame = readBlame(*f);
  if (auto f = entry.find("truth_stderr")) r.truthStderr = f->number();
}

}  // namespace report
