#include "reports/figures/measure.h"

#include <algorithm>
#include <functional>
#include <map>

#include "base/number.h"
#include "base/pattern.h"
#include "reports/record_view.h"

namespace report {
namespace {

using Get = std::optional<double> (*)(const Record&, const std::string& argument);

struct Measure {
  const char* title;
  bool time;
  bool takesArgument;
  Get get;
};

std::optional<double> medianOf(const std::optional<Distribution>& d) {
  return d ? std::optional(d->median) : std::nullopt;
}

const RegionError* regionOf(const Record& r, const std::string& name) {
  const auto found = std::ranges::find(r.visibilityRegions, name, &RegionError::region);
  return found == r.visibilityRegions.end() ? nullptr : &*found;
}

/// Sum over the passes of a label.
template <class Count>
std::optional<double> passesOf(const Record& r, const std::string& glob, Count PassRecord::*count) {
  double sum = 0;
  const base::Pattern wanted = base::Pattern::glob(glob);
  for (const PassRecord& p : r.passes)
    if (wanted.found(p.label)) sum += double(p.*count);
  return r.passes.empty() ? std::nullopt : std::optional(sum);
}

const std::map<std::string, Measure>& measures() {
  using R = const Record&;
  using A = const std::string&;
  static const std::map<std::string, Measure> kMeasures = {
      {"time", {"time, ms", true, false, [](R r, A) { return medianOf(comparedTime(r)); }}},
      {"cpu_ms",
       {"CPU time of all threads, ms", true, false, [](R r, A) { return medianOf(r.cpu); }}},
      {"frame_ms", {"frame time, ms", true, false, [](R r, A) { return medianOf(r.frame); }}},
      {"shadow_ms", {"shadow time, ms", true, false, [](R r, A) { return r.shadowMs; }}},
      {"scene_ms", {"scene time, ms", true, false, [](R r, A) { return r.sceneMs; }}},
      {"combined_ms", {"combined time, ms", true, false, [](R r, A) { return r.combinedMs; }}},
      {"stamped_frame_ms",
       {"stamped frame, ms", true, false, [](R r, A) { return r.stampedFrameMs; }}},
      {"passes",
       {"passes", false, true,
        [](R r, A a) {
          return a.empty() ? std::optional(double(r.passCount)) : passesOf(r, a, &PassRecord::count);
        }}},
      {"draws",
       {"draws", false, true,
        [](R r, A a) {
          return a.empty() ? std::optional(double(r.drawCount)) : passesOf(r, a, &PassRecord::draws);
        }}},
      {"triangles",
       {"triangles", false, true,
        [](R r, A a) {
          return a.empty() ? std::optional(double(r.triangleCount))
                           : passesOf(r, a, &PassRecord::triangles);
        }}},
      {"bytes",
       {"bytes", false, true,
        [](R r, A a) -> std::optional<double> {
          if (a.empty()) return double(r.bytes);
          double sum = 0;
          const base::Pattern wanted = base::Pattern::glob(a);
          for (const auto& [label, bytes] : r.bytesByLabel)
            if (wanted.found(label)) sum += double(bytes);
          return sum;
        }}},
      {"counts",
       {"counts", false, true,
        [](R r, A a) -> std::optional<double> {
          const auto count = r.counts.find(std::string(a));
          return count == r.counts.end() ? std::nullopt : std::optional(double(count->second));
        }}},
      {"visibility",
       {"visibility RMSE", false, false,
        [](R r, A) {
          return r.visibility ? std::optional(r.visibility->all.rmse) : std::nullopt;
        }}},
      {"visibility_interior",
       {"visibility RMSE away from edges", false, false,
        [](R r, A) {
          return r.visibility ? std::optional(r.visibility->interior.rmse) : std::nullopt;
        }}},
      {"visibility_bias",
       {"visibility bias", false, false,
        [](R r, A) {
          return r.visibility ? std::optional(r.visibility->all.bias) : std::nullopt;
        }}},
      {"image",
       {"image RMSE", false, false,
        [](R r, A) { return r.image ? std::optional(r.image->all.rmse) : std::nullopt; }}},
      {"flip",
       {"FLIP", false, false,
        [](R r, A) { return r.image ? std::optional(r.image->flip) : std::nullopt; }}},
      {"noise",
       {"noise", false, false,
        [](R r, A) { return r.noise ? std::optional(r.noise->noise) : std::nullopt; }}},
      {"layer",
       {"visibility RMSE of layer", false, true,
        [](R r, A a) -> std::optional<double> {
          std::optional<double> most;
          for (const LayerError& l : r.visibilityLayers)
            if (std::to_string(l.layer) == a) most = std::max(most.value_or(0), l.error.all.rmse);
          return most;
        }}},
      {"region",
       {"visibility RMSE of region", false, true,
        [](R r, A a) {
          const RegionError* e = regionOf(r, a);
          return e ? std::optional(e->rmse) : std::nullopt;
        }}},
      {"region_noise", {"noise of region", false, true, [](R r, A a) {
                          const RegionError* e = regionOf(r, a);
                          return e ? e->noise : std::nullopt;
                        }}}};
  return kMeasures;
}

struct Named {
  const Measure* measure;
  std::string argument;
};

Named find(const std::string& text) {
  const size_t colon = text.find(':');
  const auto found = measures().find(text.substr(0, colon));
  if (found == measures().end()) return {nullptr, ""};
  const std::string argument = colon == text.npos ? "" : text.substr(colon + 1);
  if (!argument.empty() && !found->second.takesArgument) return {nullptr, ""};
  return {&found->second, argument};
}

/// Parameters of "NAME:a=1,b=2?edits" as places in the text.
struct Place {
  size_t begin = std::string::npos, end = 0, value = 0;
};

Place placeOf(const std::string& scene, const std::string& name) {
  const size_t stop = std::min(scene.find('?'), scene.size());
  const size_t colon = scene.find(':');
  if (colon == scene.npos || colon >= stop) return {};
  for (size_t at = colon + 1; at < stop;) {
    const size_t end = std::min(scene.find(',', at), stop);
    if (scene.compare(at, name.size() + 1, name + "=") == 0) return {at, end, at + name.size() + 1};
    at = end + 1;
  }
  return {};
}

}  // namespace

std::optional<Measured> measured(const Record& record, const std::string& measure) {
  const auto [known, argument] = find(measure);
  if (!known || record.status != Status::Ok || (known->time && !record.contamination.empty()))
    return {};
  const auto value = known->get(record, argument);
  if (!value) return {};
  return Measured{*value, known->time ? *value * record.precision.value_or(0) : 0};
}

bool isMeasure(const std::string& measure) { return find(measure).measure != nullptr; }

bool isTime(const std::string& measure) {
  const Measure* known = find(measure).measure;
  return known && known->time;
}

std::string measureTitle(const std::string& measure) {
  const auto [known, argument] = find(measure);
  if (!known) return measure;
  return known->title + (argument.empty() ? "" : " " + argument);
}

double xOf(const Figure& figure, const Record& record) {
  std::string text;
  if (const Place place = placeOf(record.id.scene, figure.x); place.end > 0)
    text = record.id.scene.substr(place.value, place.end - place.value);
  else if (const auto knob = record.knobs.find(figure.x); knob != record.knobs.end())
    text = knob->second;
  return base::readNumber(text, {}).value_or(figure.xFallback);
}

std::string sceneWithoutX(const Figure& figure, const Record& record) {
  std::string scene = record.id.scene;
  const Place place = placeOf(scene, figure.x);
  if (place.end == 0) return scene;
  // With the comma before it, or the one after it when it is the first; the colon goes with the
  // last.
  const bool first = scene[place.begin - 1] == ':';
  const bool last = place.end >= std::min(scene.find('?'), scene.size());
  if (!first || last) return scene.erase(place.begin - 1, place.end - place.begin + 1);
  return scene.erase(place.begin, place.end - place.begin + 1);
}

}  // namespace report
