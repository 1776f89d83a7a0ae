#include "suites/harness/cell.h"

#include "base/text.h"
#include "techniques/render/registry.h"
#include "techniques/render/renderer.h"

namespace sb {

const TechniqueInfo& referenceInfo() {
  static const TechniqueInfo info = {
      .name = kReferenceTechnique,
      .title = "the truth's own tracer, on the CPU",
      .paper = "this project",
      .knobs = {{.name = "rays",
                 .unit = "rays",
                 .help = "shadow rays to each light with an extent, in a fixed (0,2)-pattern; one "
                         "goes to its centre",
                 .fallback = "1",
                 .choices = {"1", "2", "4", "8", "16", "32", "64", "128", "256", "512", "1024"},
                 .sweep = {"1", "4", "16", "64", "256"}}}};
  return info;
}

Knobs cellKnobs(const CellId& id) {
  if (isReference(id)) return Knobs::resolve(referenceInfo().knobs, id.knobs);
  return Knobs::resolve(
      knobsOf(shadowTechnique(id.technique).info, transparencyTechnique(id.transparency).info),
      id.knobs);
}

std::string cellName(const CellId& id) {
  std::string name = id.technique;
  if (id.transparency != kDefaultTransparency) name += "+" + id.transparency;
  // Files may be called anything: names go to terminals, tables and filters.
  name += "/" + id.backend + "/" + base::printable(id.scene);
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

std::string cellCommand(const CellId& id, uint32_t seeds) {
  std::string command = "./bench --technique " + id.technique;
  if (id.transparency != kDefaultTransparency) command += "+" + id.transparency;
  command += " --backend " + id.backend + " --scene " + base::shellWord(id.scene);
  for (const auto& [name, value] : id.knobs)
    command += " --set " + base::shellWord(name + "=" + value);
  if (seeds != kDefaultSeeds && !isReference(id) && shadowTechnique(id.technique).info.stochastic)
    command += " --seeds " + std::to_string(seeds);
  if (id.seed != 0) command += " --seed " + std::to_string(id.seed);
  return command + " --size " + std::to_string(id.width) + "x" + std::to_string(id.height);
}

}  // namespace sb
