#include "suites/stability/stability.h"

#include <algorithm>
#include <set>

#include "backends/rhi/memory_limit.h"
#include "base/text.h"
#include "suites/harness/cell.h"
#include "suites/harness/selection.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

const StabilityCase& caseOf(const std::string& id) {
  std::vector<std::string> names;
  for (const StabilityCase& c : stabilityCases()) {
    if (c.id == id) return c;
    names.push_back(c.id);
  }
  throw InputError("cases", unknownName("case", id, names));
}

std::string nameOf(const std::string& technique, const std::string& transparency) {
  return transparency == kDefaultTransparency ? technique : technique + "+" + transparency;
}

/// Pairs to ask: each shadow technique, and each transparency technique without shadows.
std::vector<std::pair<std::string, std::string>> allPairs() {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const ShadowEntry* s : shadowTechniques())
    pairs.emplace_back(s->info.name, std::string(kDefaultTransparency));
  for (const TransparencyEntry* t : transparencyTechniques())
    if (t->info.name != kDefaultTransparency) pairs.emplace_back("none", t->info.name);
  return pairs;
}

std::pair<std::string, std::string> pairOf(const std::string& name) {
  const size_t plus = name.find('+');
  const std::string transparency =
      plus == std::string::npos ? std::string(kDefaultTransparency) : name.substr(plus + 1);
  return {shadowTechnique(name.substr(0, plus)).info.name,
          transparencyTechnique(transparency).info.name};
}

/// `none` answers nothing about shadows; whatever has shadows is not asked about transparency
/// twice.
bool concerns(const StabilityCase& c, const std::string& technique) {
  return c.asks == Asks::Both || (c.asks == Asks::Shadows) == (technique != "none");
}

std::string variantName(const StabilityJob& job) {
  std::string name = nameOf(job.technique, job.transparency);
  for (const auto& [knob, value] : job.knobs) name += "/" + knob + ":" + value;
  return name;
}

std::vector<KnobInfo> knobsOf(const StabilityJob& job) {
  return sb::knobsOf(shadowTechnique(job.technique).info,
                     transparencyTechnique(job.transparency).info);
}

/// A knob that none of the pairs has is a mistake.
void requireKnown(const StabilitySelection& selection,
                  const std::vector<std::pair<std::string, std::string>>& pairs) {
  std::set<std::string> known;
  for (const auto& [technique, transparency] : pairs)
    for (const KnobInfo& knob :
         knobsOf({.caseId = "", .technique = technique, .transparency = transparency, .backend = ""}))
      known.insert(knob.name);
  for (const auto& variant : selection.variants)
    for (const auto& [knob, value] : variant)
      if (!known.contains(knob))
        throw InputError("knob",
                         unknownName("knob", knob, std::vector(known.begin(), known.end())));
}

bool hasKnobs(const StabilityJob& job) {
  const auto infos = knobsOf(job);
  return std::ranges::all_of(job.knobs, [&](const auto& knob) {
    return std::ranges::find(infos, knob.first, &KnobInfo::name) != infos.end();
  });
}

/// Keys of TechniqueInfo::breaksIn: "case", or "case knob:value" for one variant.
std::string whyItBreaks(const TechniqueInfo& info, const StabilityJob& job) {
  std::vector<std::string> keys;
  for (const auto& [knob, value] : job.knobs) keys.push_back(job.caseId + " " + knob + ":" + value);
  keys.push_back(job.caseId);
  for (const std::string& key : keys)
    if (const auto known = info.breaksIn.find(key); known != info.breaksIn.end())
      return known->second;
  return "";
}

}  // namespace

std::string jobName(const StabilityJob& job) {
  return skippedStability(job, "").name();
}

std::vector<StabilityJob> stabilityJobs(const StabilitySelection& selection) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& t : selection.techniques) pairs.push_back(pairOf(t));
  if (pairs.empty()) pairs = allPairs();
  requireKnown(selection, pairs);
  std::vector<std::string> ids = selection.cases;
  if (ids.empty())
    for (const StabilityCase& c : stabilityCases()) ids.push_back(c.id);
  const bool own = selection.scenes.empty();
  if (!own)
    std::erase_if(ids, [](const std::string& id) { return !caseOf(id).onScene.run; });
  const base::Pattern wanted = parseFilter(selection.filter);
  std::vector<StabilityJob> jobs;
  for (const std::string& id : ids) {
    const StabilityCase& c = caseOf(id);
    for (const auto& [technique, transparency] : pairs)
      for (const auto& knobs : selection.variants)
        for (const std::string& backend : selection.backends)
          for (const std::string& scene : own ? std::vector<std::string>{""} : selection.scenes) {
            StabilityJob job{id, technique, transparency, backend, knobs, selection.seeds, scene};
            if (selection.size) job.size = *selection.size;
            job.quick = selection.quick;
            if (!concerns(c, technique) || !hasKnobs(job)) continue;
            if (wanted.found(jobName(job))) jobs.push_back(std::move(job));
          }
  }
  return jobs;
}

report::StabilityRecord skippedStability(const StabilityJob& job, const std::string& why) {
  const StabilityCase& c = caseOf(job.caseId);
  const bool own = job.scene.empty();
  return {.id = c.id,
          .title = c.title,
          .property = own ? c.property : c.onScene.property,
          .reason = own ? c.reason : c.onScene.reason,
          .technique = variantName(job),
          .backend = job.backend,
          .scene = base::printable(job.scene),
          .width = own ? 0 : job.size.width,
          .height = own ? 0 : job.size.height,
          .parameter = c.parameter,
          .logarithmic = c.logarithmic,
          .curve = {},
          .breaksAt = {},
          .verdict = report::Verdict::Skipped,
          .why = why};
}

report::StabilityRecord failedStability(const StabilityJob& job, const std::string& why) {
  report::StabilityRecord record = skippedStability(job, why);
  record.verdict = report::Verdict::Fail;
  return record;
}

report::StabilityRecord runStability(const StabilityJob& job, const DeviceContext& device,
                                     const DeviceContext* other, const Scene* given) {
  const StabilityCase& c = caseOf(job.caseId);
  std::optional<Scene> scene;
  if (!job.scene.empty()) scene = given ? *given : makeScene(job.scene);
  if (scene) scene->path.clear();  // properties of one picture, from where the path ends
  const CaseContext context{.device = device,
                            .other = other,
                            .technique = job.technique,
                            .transparency = job.transparency,
                            .knobs = job.knobs,
                            .seeds = job.seeds,
                            .quick = job.quick,
                            .scene = scene ? &*scene : nullptr,
                            .size = job.size};
  if (c.leavesOut)
    if (const std::string why = c.leavesOut(context); !why.empty())
      return skippedStability(job, why);
  report::StabilityRecord record = skippedStability(job, "");
  try {
    Found found = (scene ? c.onScene.run : c.run)(context);
    if (!found.leftOut.empty()) return skippedStability(job, found.leftOut);
    record.curve = std::move(found.curve);
    for (const TechniqueInfo* info : {&context.info(), &context.transparencyInfo()})
      if (const std::string why = whyItBreaks(*info, job); !why.empty()) found.expected = why;
    report::judge(record, found.expected);
  } catch (const Unsupported& error) {
    return skippedStability(job, error.what());
  } catch (const rhi::Error& error) {
    // What a device says it lacks is no failure; anything else that a driver refuses is.
    if (rhi::isDeviceLost(error)) throw;
    if (rhi::isTooLarge(error)) return skippedStability(job, rhi::whyTooLarge(error));
    if (rhi::isDeclaredLack(error)) return skippedStability(job, error.what());
    return failedStability(job, error.what());
  }
  return record;
}

}  // namespace sb
