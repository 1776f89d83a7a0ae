#include "reports/record_view.h"

#include <algorithm>
#include <map>
#include <set>

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

std::vector<std::string> unshownEffects(const Run& run) {
  struct Scene {
    std::vector<const Record*> cells;
    std::set<std::string> effects;
  };
  std::map<std::string, Scene> scenes;
  for (const Record& r : run.records) {
    if (r.status != Status::Ok) continue;
    Scene& scene = scenes[r.id.scene];
    scene.cells.push_back(&r);
    scene.effects.insert(r.effectsUnrepresented.begin(), r.effectsUnrepresented.end());
  }
  std::vector<std::string> out;
  for (const auto& [name, scene] : scenes)
    for (const std::string& effect : scene.effects) {
      const auto lacks = [&](const Record* r) {
        return std::ranges::find(r->effectsUnrepresented, effect) != r->effectsUnrepresented.end();
      };
      const std::string text = name + " calls for " + effect + ", which ";
      if (std::ranges::all_of(scene.cells, lacks)) {
        out.push_back(text + "no cell here shows");
        continue;
      }
      std::set<std::string> techniques;
      for (const Record* r : scene.cells)
        if (lacks(r) && r->role != Role::Baseline) techniques.insert(techniqueOf(*r));
      std::string listed;
      for (const std::string& t : techniques) listed += (listed.empty() ? "" : ", ") + t;
      if (!listed.empty())
        out.push_back(text + listed + (techniques.size() == 1 ? " does" : " do") + " not show");
    }
  return out;
}

std::string whyOf(const Record& r, const std::string& key) {
  const auto found = r.why.find(key);
  return found == r.why.end() ? "" : found->second;
}

}  // namespace report
