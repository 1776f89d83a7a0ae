// The page's data for its script: points, fronts and the figures that are shown beside a point.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "reports/html/elements/text.h"
#include "reports/html/sections/sections.h"

namespace report {
namespace {

std::string errorText(double error, const TradePoint* p) {
  if (!p || p->errorInterval.low >= p->errorInterval.high) return figure(error);
  return withInterval(error, p->errorInterval.low, p->errorInterval.high);
}

std::string frontText(const TradePoint& p) {
  if (!p.front) return "no: another cell is at least as fast and as exact";
  return p.uncertain ? "perhaps: within the intervals another cell may be better" : "yes";
}

/// Label and text, in the order they are shown in.
Json figures(const ScenePart& part, const Record& r) {
  Json out = Json::array();
  const auto add = [&](const std::string& label, const std::string& text) {
    out.push_back({label, text});
  };
  const TradePoint* visibility = pointOf(part.visibility, r);
  const TradePoint* image = pointOf(part.image, r);
  if (const TradePoint* p = visibility ? visibility : image)
    add(part.timeName(), withInterval(p->time, p->timeInterval.low, p->timeInterval.high) + " ms");
  if (part.timeKey == "cpu_ms" && r.frame) add("Frame, wall time", figure(r.frame->median) + " ms");
  for (const Ratio& x : r.ratios)
    if (x.kind == "baseline") add("× none", withInterval(x.value, x.low, x.high));
  if (r.visibility) {
    add("Visibility RMSE", errorText(r.visibility->all.rmse, visibility));
    if (r.visibility->weighted)
      add("Visibility RMSE, weighed by light", figure(*r.visibility->weighted));
    add("Visibility bias", figure(r.visibility->all.bias));
    const uint64_t inside = r.visibility->oneSidedInterior;
    if (r.visibility->oneSided > 0)
      add("Pixels of one side alone", std::to_string(inside) + " away from edges, " +
                                          std::to_string(r.visibility->oneSided - inside) +
                                          " at edges");
  }
  if (r.image) {
    add("Image RMSE", errorText(r.image->all.rmse, image));
    add("FLIP", figure(r.image->flip));
    if (r.exposure != 1) add("Exposure", figure(r.exposure));
  }
  if (r.noise)
    add("Noise", figure(r.noise->noise) + " over " + std::to_string(r.noise->seeds) + " seeds");
  if (r.certificate)
    add("Certificate", std::string(certificateVerdict(*r.certificate)) + ", " +
                           counted(r.certificate->regions.size(), "region", "regions") + " tested");
  add("Memory", mebibytes(r.bytes) + " MiB");
  if (visibility) add("On the front, visibility", frontText(*visibility));
  if (image) add("On the front, image", frontText(*image));
  return out;
}

Json cellJson(const PageModel& model, const ScenePart& part, const Record& r,
              const PictureSet& pictures) {
  Json shown = Json::object();
  for (const char* role : {"image", "truth", "error", "blame"})
    if (const std::string hash = pictures.shown(r, role); !hash.empty()) shown[role] = hash;
  return {{"name", r.name},
          {"technique", techniqueOf(r)},
          {"color", model.colorClass(techniqueOf(r))},
          {"backend", r.id.backend},
          {"shape", model.shapeClass(r.id.backend)},
          {"variant", variantOf(r.id)},
          {"command", r.command},
          {"width", r.id.width},
          {"height", r.id.height},
          {"pictures", std::move(shown)},
          {"figures", figures(part, r)}};
}

/// A cell that joins several backends' points is one point.
Json pointsJson(const PageModel& model, const std::vector<const TradeOff*>& all) {
  Json out = Json::array();
  std::set<const Record*> seen;
  for (const TradeOff* t : all)
    for (const TradePoint& p : t->points) {
      if (!seen.insert(p.record).second) continue;
      bool front = false, uncertain = true;
      for (const TradeOff* other : all)
        for (const TradePoint& q : other->points)
          if (q.record == p.record && q.front) front = true, uncertain = uncertain && q.uncertain;
      out.push_back({{"cell", model.indexOf(*p.record)},
                     {"time", {p.time, p.timeInterval.low, p.timeInterval.high}},
                     {"error", {p.error, p.errorInterval.low, p.errorInterval.high}},
                     {"front", front},
                     {"uncertain", front && uncertain}});
    }
  return out;
}

/// The cells of each backend's front, by time.
Json frontsJson(const PageModel& model, const std::vector<const TradeOff*>& all) {
  Json out = Json::array();
  for (const TradeOff* t : all) {
    std::vector<const TradePoint*> front;
    for (const TradePoint& p : t->points)
      if (p.front) front.push_back(&p);
    std::ranges::stable_sort(front, {}, &TradePoint::time);
    Json cells = Json::array();
    for (const TradePoint* p : front) cells.push_back(model.indexOf(*p->record));
    out.push_back({{"backend", t->backend}, {"cells", std::move(cells)}});
  }
  return out;
}

}  // namespace

std::string pageData(const PageModel& model, const PictureSet& pictures, const CurveSet& curves) {
  Json cells = Json::object(), parts = Json::array();
  for (const ScenePart& part : model.parts) {
    for (size_t index : part.cells)
      if (const Record& r = model.run.records[index]; r.status == Status::Ok)
        cells[std::to_string(index)] = cellJson(model, part, r, pictures);
    parts.push_back({{"id", part.id},
                     {"title", part.title()},
                     {"timeName", part.timeName()},
                     {"points",
                      {{"visibility", pointsJson(model, part.visibility)},
                       {"image", pointsJson(model, part.image)}}},
                     {"fronts",
                      {{"visibility", frontsJson(model, part.visibility)},
                       {"image", frontsJson(model, part.image)}}}});
  }
  return scriptJson({{"cells", std::move(cells)},
                     {"parts", std::move(parts)},
                     {"curves", curves.json(model)}});
}

}  // namespace report
