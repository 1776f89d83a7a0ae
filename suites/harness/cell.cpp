#include "suites/harness/cell.h"

#include <algorithm>

#include "base/text.h"
#include "techniques/plan/error.h"
#include "techniques/render/registry.h"

namespace sb {

const TechniqueInfo& referenceInfo() {
  static const TechniqueInfo info = {
      .name = "RayTraced",
      .title = "the truth's own tracer, on the CPU",
      .paper = "this project",
      .knobs = {{.name = "rays",
                 .unit = "rays",
                 .help = "shadow rays to each light with an extent, in a fixed (0,2)-pattern; one "
                         "goes to its centre",
                 .fallback = "1",
                 .choices = {"1", "2", "4", "8", "16", "32", "64", "128", "256", "512", "1024"},
                 .sweep = {"1", "4", "16", "64", "256"}}},
      .tracer = true};
  return info;
}

bool isReference(const CellId& id) { return id.technique == referenceInfo().name; }

report::Role roleOf(const CellId& id) {
  const TechniqueInfo& info = isReference(id) ? referenceInfo() : *techniquesOf(id).shadow;
  return info.tracer     ? report::Role::Tracer
         : info.baseline ? report::Role::Baseline
                         : report::Role::Technique;
}

CellId parseTechniques(const std::string& text) {
  if (text == referenceInfo().name) return {.technique = text};
  const size_t at = std::min(text.find('@'), text.size());
  const size_t plus = std::min(text.find('+'), at);
  CellId id{.technique = text.substr(0, plus)};
  if (plus < at) id.transparency = text.substr(plus + 1, at - plus - 1);
  if (at < text.size()) id.lights = text.substr(at + 1);
  if (text.find_first_of("+@", at + 1) != text.npos ||
      id.transparency.find('+') != id.transparency.npos)
    throw InputError("--technique",
                     "found '" + text + "', expected TECHNIQUE[+TRANSPARENCY][@LIGHTS]");
  if (isReference(id))
    throw InputError("--technique", "found '" + text + "', expected " + id.technique +
                                        " alone: it traces, and needs no technique beside it");
  techniquesOf(id);
  return id;
}

TechniqueSet techniquesOf(const CellId& id) {
  return {&shadowTechnique(id.technique).info, &transparencyTechnique(id.transparency).info,
          &lightTechnique(id.lights).info};
}

std::vector<KnobInfo> knobInfosOf(const CellId& id) {
  return isReference(id) ? referenceInfo().knobs : knobsOf(techniquesOf(id));
}

Knobs cellKnobs(const CellId& id) {
  return Knobs::resolve(knobInfosOf(id), {id.knobs.begin(), id.knobs.end()});
}

CellId withKnobs(CellId id, const std::map<std::string, std::string>& values) {
  id.knobs = Knobs::resolve(knobInfosOf(id), values).changed();
  return id;
}

CellId baselineOf(const CellId& id) {
  CellId baseline = id;
  baseline.technique = baselineTechnique().info.name;
  // Knobs of transparency and lights stay; those of shadows mean nothing here.
  const std::vector<KnobInfo> infos = knobInfosOf(baseline);
  std::erase_if(baseline.knobs, [&](const auto& knob) {
    return std::ranges::find(infos, knob.first, &KnobInfo::name) == infos.end();
  });
  return baseline;
}

CellId onAnyBackend(CellId id) {
  id.backend.clear();
  return id;
}

CellId recordedId(CellId id) {
  id.scene = base::printable(id.scene);
  return id;
}

std::string cellCommand(const CellId& id, uint32_t seeds) {
  std::string command = "./bench --technique " + techniqueName(id);
  command += " --backend " + id.backend + " --scene " + base::shellWord(id.scene);
  for (const auto& [name, value] : id.knobs)
    command += " --set " + base::shellWord(name + "=" + value);
  if (seeds != kDefaultSeeds && !isReference(id) && techniquesOf(id).shadow->stochastic)
    command += " --seeds " + std::to_string(seeds);
  if (id.seed != 0) command += " --seed " + std::to_string(id.seed);
  return command + " --size " + std::to_string(id.width) + "x" + std::to_string(id.height);
}

}  // namespace sb
