#include "suites/stability/stability.h"

#include <algorithm>
#include <set>

#include "backends/rhi/memory_limit.h"
#include "base/text.h"
#include "suites/harness/cell.h"
#include "suites/harness/suite/selection.h"
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

/// Techniques to ask, as cells of which nothing else is known: each shadow technique, and without
/// shadows each transparency technique and loop over lights.
std::vector<CellId> allTechniques() {
  std::vector<CellId> all;
  const std::string& lit = baselineTechnique().info.name;
  for (const ShadowEntry* s : shadowTechniques()) all.push_back({.technique = s->info.name});
  for (const TransparencyEntry* t : transparencyTechniques())
    if (t->info.name != kDefaultTransparency)
      all.push_back({.technique = lit, .transparency = t->info.name});
  for (const LightsEntry* l : lightTechniques())
    if (l->info.name != kDefaultLights) all.push_back({.technique = lit, .lights = l->info.name});
  return all;
}

/// Without shadows there is nothing to say about them; whatever has shadows is not asked about
/// transparency twice.
bool concerns(const StabilityCase& c, const CellId& drawn) {
  const bool shadows = !techniquesOf(drawn).shadow->baseline;
  return c.asks == Asks::Both || (c.asks == Asks::Shadows) == shadows;
}

CellId techniquesOfJob(const StabilityJob& job) {
  return {.technique = job.technique, .transparency = job.transparency, .lights = job.lights};
}

std::string variantName(const StabilityJob& job) {
  std::string name = techniqueName(techniquesOfJob(job));
  for (const auto& [knob, value] : job.knobs) name += "/" + knob + ":" + value;
  return name;
}

/// A knob that none of the techniques has is a mistake.
void requireKnown(const StabilitySelection& selection, const std::vector<CellId>& techniques) {
  std::set<std::string> known;
  for (const CellId& drawn : techniques)
    for (const KnobInfo& knob : knobInfosOf(drawn)) known.insert(knob.name);
  for (const auto& variant : selection.variants)
    for (const auto& [knob, value] : variant)
      if (!known.contains(knob))
        throw InputError("knob",
                         unknownName("knob", knob, std::vector(known.begin(), known.end())));
}

bool hasKnobs(const StabilityJob& job) {
  const auto infos = knobInfosOf(techniquesOfJob(job));
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
  std::vector<CellId> techniques;
  for (const std::string& t : selection.techniques) techniques.push_back(parseTechniques(t));
  if (techniques.empty()) techniques = allTechniques();
  requireKnown(selection, techniques);
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
    for (const CellId& drawn : techniques)
      for (const auto& knobs : selection.variants)
        for (const std::string& backend : selection.backends)
          for (const std::string& scene : own ? std::vector<std::string>{""} : selection.scenes) {
            StabilityJob job{.caseId = id,
                             .technique = drawn.technique,
                             .transparency = drawn.transparency,
                             .lights = drawn.lights,
                             .backend = backend,
                             .knobs = knobs,
                             .seeds = selection.seeds,
                             .scene = scene,
                             .quick = selection.quick};
            if (selection.size) job.size = *selection.size;
            if (!concerns(c, drawn) || !hasKnobs(job)) continue;
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
          .role = variantName(job) == baselineTechnique().info.name ? report::Role::Baseline
                                                                    : report::Role::Technique,
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
                            .lights = job.lights,
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
    for (const TechniqueInfo* info : techniquesOf(techniquesOfJob(job)).all())
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
