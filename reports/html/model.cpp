#include "reports/html/model.h"

#include <algorithm>
#include <set>

#include "reports/html/elements/text.h"

namespace report {
namespace {

void addOnce(std::vector<std::string>& list, const std::string& name) {
  if (!std::ranges::count(list, name)) list.push_back(name);
}

size_t placeIn(const std::vector<std::string>& list, const std::string& name) {
  return size_t(std::ranges::find(list, name) - list.begin());
}

}  // namespace

std::string ScenePart::title() const {
  return scene + ", " + std::to_string(width) + "×" + std::to_string(height);
}

std::string ScenePart::timeName() const {
  return timeKey == "cpu_ms" ? "CPU time of all threads" : "Frame time";
}

PageModel::PageModel(const Run& r)
    : run(r),
      visibility(tradeOffs(r, ErrorKind::Visibility)),
      image(tradeOffs(r, ErrorKind::Image)) {
  // What has no time of its own, or belongs to no API, goes where its scene's other cells are.
  auto partOf = [&](const Record& record) -> ScenePart& {
    const std::string key = record.role == Role::Tracer ? "" : timeKeyOf(record);
    for (ScenePart& p : parts)
      if (p.scene == record.id.scene && p.width == record.id.width &&
          p.height == record.id.height && (p.timeKey == key || p.timeKey.empty() || key.empty())) {
        if (p.timeKey.empty()) p.timeKey = key;
        return p;
      }
    parts.push_back({.id = "scene" + std::to_string(parts.size()),
                     .scene = record.id.scene,
                     .width = record.id.width,
                     .height = record.id.height,
                     .timeKey = key});
    return parts.back();
  };
  for (const Record& record : run.records) {
    addOnce(techniques, techniqueOf(record));
    if (record.role == Role::Baseline) baseline = record.id.technique;
    addOnce(backends, record.id.backend);
    addOnce(scenes, record.id.scene);
    partOf(record).cells.push_back(indexOf(record));
  }
  for (const StabilityRecord& r : run.stability) {
    addOnce(techniques, r.technique);
    if (r.role == Role::Baseline) baseline = r.technique;
    addOnce(backends, r.backend);
  }
  for (ScenePart& part : parts)
    if (part.timeKey.empty()) part.timeKey = timeKeyOf(run.records[part.cells.front()]);
  // Reference rows belong to no API: the APIs' shapes should not depend on whether there are any.
  std::ranges::stable_partition(backends, [&](const std::string& b) {
    return std::ranges::none_of(run.records, [&](const Record& record) {
      return record.role == Role::Tracer && record.id.backend == b;
    });
  });
  auto deal = [&](const std::vector<TradeOff>& all,
                  std::vector<const TradeOff*> ScenePart::*member) {
    for (const TradeOff& t : all)
      for (ScenePart& p : parts)
        if (p.scene == t.scene && p.width == t.width && p.height == t.height &&
            p.timeKey == t.timeKey)
          (p.*member).push_back(&t);
  };
  deal(visibility, &ScenePart::visibility);
  deal(image, &ScenePart::image);
}

std::string PageModel::colorClass(const std::string& technique) const {
  constexpr size_t kColors = 9;
  if (technique == baseline) return "tn";
  const size_t place = placeIn(techniques, technique);
  return "t" + std::to_string((place - (placeIn(techniques, baseline) < place ? 1 : 0)) % kColors);
}

std::string PageModel::shapeClass(const std::string& backend) const {
  constexpr size_t kShapes = 5;
  return "b" + std::to_string(placeIn(backends, backend) % kShapes);
}

std::string PageModel::techniqueHtml(const std::string& technique) const {
  return "<span class=\"technique " + colorClass(technique) + "\">" + escaped(technique) +
         "</span>";
}

std::string PageModel::backendHtml(const std::string& backend) const {
  return "<span class=\"backend " + shapeClass(backend) + "\">" + escaped(backend) + "</span>";
}

}  // namespace report
