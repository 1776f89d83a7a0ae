#include "suites/cli/options/help.h"

#include "base/number.h"
#include "base/text.h"
#include "reports/record.h"
#include "suites/harness/cell.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

/// "1|2|4", or "0..10 degrees".
std::string valuesText(const std::vector<std::string>& choices, double low, double high,
                       const std::string& unit) {
  if (choices.empty())
    return base::numberText(low) + ".." + base::numberText(high) + (unit.empty() ? "" : " " + unit);
  std::string out;
  for (const std::string& c : choices) out += (out.empty() ? "" : "|") + c;
  return out;
}

void addLine(std::string& out, const std::string& name, const std::string& values,
             const std::string& fallback, const std::string& help) {
  out += "      " + name + "=" + values + "  [" + fallback + "]  " + help + "\n";
}

void describe(std::string& out, const TechniqueInfo& info) {
  out += "  " + info.name + ": " + info.title + " (" + info.paper + ")\n";
  for (const KnobInfo& k : info.knobs)
    addLine(out, k.name, valuesText(k.choices, k.min, k.max, k.odd ? "odd " + k.unit : k.unit),
            k.fallback, k.help);
}

}  // namespace

std::string helpFooter() {
  std::string out = "Techniques and their knobs (--set knob=value[,value...]):\n";
  for (const auto* t : shadowTechniques()) describe(out, t->info);
  describe(out, referenceInfo());
  out += "Camera transparency (--technique NAME+TRANSPARENCY; NAME alone means NAME+Sorted):\n";
  for (const auto* t : transparencyTechniques()) describe(out, t->info);
  out += "Loops over lights (--technique NAME@LIGHTS; NAME alone means NAME@AllLights):\n";
  for (const auto* t : lightTechniques()) describe(out, t->info);
  out += "Scenes (--scene NAME:param=value,... or a .gltf or .glb file):\n";
  for (const SceneInfo& s : proceduralScenes()) {
    out += "  " + s.name + ": " + s.help + "\n";
    for (const SceneParam& p : s.params)
      addLine(out, p.name, valuesText(p.choices, p.low, p.high, p.unit), p.fallbackText(), p.help);
  }
  out +=
      "Names of cells: TECHNIQUE[+TRANSPARENCY][@LIGHTS]/backend/scene:params/knob:value/WxH;\n"
      "what is at its default is left out. --filter takes a name as --list prints it, a part of\n"
      "it, or a regular expression (RE2) that is found anywhere in it.\n"
      "Google Benchmark's own --benchmark_* flags work too.\n"
      "Exit code: 0 all cells ok or skipped, 1 a cell failed, was skipped for want of memory (see\n"
      "--allow-skips) or none was measured, or a result could not be written, 2 wrong input,\n"
      "128 + N ended by signal N: what is finished is written, and --resume goes on.\n";
  return out;
}

std::string joinedNames(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

std::string commandLine(const std::vector<std::string>& arguments) {
  std::string out = "bench";
  for (const std::string& word : arguments) out += " " + base::shellWord(word);
  return out;
}

std::string versionText() {
  const report::Run run = report::describeMachine("bench", SHADOWBENCH_VERSION);
  return "ShadowBench " + run.version + "\ncommit " + run.commit + "\nbuild " + run.buildType +
         "\ncompiler " + run.compiler + "\nOS " + run.os + "\nCPU " + run.cpuModel;
}

}  // namespace sb
