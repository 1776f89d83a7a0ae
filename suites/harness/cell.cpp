#include "suites/harness/cell.h"

#include "techniques/common/registry.h"
#include "techniques/common/renderer.h"

namespace sb {
namespace {

/// Words with characters a shell would read stand in single quotes.
std::string shellWord(const std::string& text) {
  if (text.find_first_of(" ;'\"$&|()<>*?[]#~`\\") == std::string::npos) return text;
  std::string out = "'";
  for (char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace

Knobs cellKnobs(const CellId& id) {
  if (isReference(id)) return Knobs::resolve({}, id.knobs);
  return Knobs::resolve(
      knobsOf(shadowTechnique(id.technique).info, transparencyTechnique(id.transparency).info),
      id.knobs);
}

std::string cellName(const CellId& id) {
  std::string name = id.technique;
  if (id.transparency != kDefaultTransparency) name += "+" + id.transparency;
  name += "/" + id.backend + "/" + id.scene;
  const std::string knobs = cellKnobs(id).nameSuffix();
  if (!knobs.empty()) name += "/" + knobs;
  if (id.seed != 0) name += "/seed:" + std::to_string(id.seed);
  return name + "/" + std::to_string(id.width) + "x" + std::to_string(id.height);
}

CellId baselineOf(const CellId& id) {
  CellId baseline = id;
  baseline.technique = "none";
  baseline.knobs.clear();
  // The knobs of the transparency technique stay; those of shadows mean nothing here.
  for (const KnobInfo& knob :
       knobsOf(shadowTechnique("none").info, transparencyTechnique(id.transparency).info))
    if (auto given = id.knobs.find(knob.name); given != id.knobs.end())
      baseline.knobs.insert(*given);
  return baseline;
}

std::string cellCommand(const CellId& id) {
  std::string command = "./bench --technique " + id.technique;
  if (id.transparency != kDefaultTransparency) command += "+" + id.transparency;
  command += " --backend " + id.backend + " --scene " + shellWord(id.scene);
  for (const auto& [name, value] : id.knobs) command += " --set " + name + "=" + value;
  if (id.seed != 0) command += " --seed " + std::to_string(id.seed);
  return command + " --size " + std::to_string(id.width) + "x" + std::to_string(id.height);
}

}  // namespace sb
