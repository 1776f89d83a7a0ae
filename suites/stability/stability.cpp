#include "suites/stability/stability.h"

#include <algorithm>
#include <regex>

#include "suites/harness/cell.h"
#include "techniques/common/error.h"

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
  return c.ofShadows ? technique != "none" : technique == "none";
}

}  // namespace

std::string jobName(const StabilityJob& job) {
  return job.caseId + "/" + nameOf(job.technique, job.transparency) + "/" + job.backend;
}

std::vector<StabilityJob> stabilityJobs(const std::vector<std::string>& techniques,
                                        const std::vector<std::string>& cases,
                                        const std::vector<std::string>& backends,
                                        const std::string& filter) {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& t : techniques) pairs.push_back(pairOf(t));
  if (techniques.empty()) pairs = allPairs();
  std::vector<std::string> ids = cases;
  if (ids.empty())
    for (const StabilityCase& c : stabilityCases()) ids.push_back(c.id);
  std::regex wanted;
  try {
    wanted = std::regex(filter);
  } catch (const std::regex_error& e) {
    throw InputError("--filter", "'" + filter + "' is no regular expression: " + e.what());
  }
  std::vector<StabilityJob> jobs;
  for (const std::string& id : ids) {
    const StabilityCase& c = caseOf(id);
    for (const auto& [technique, transparency] : pairs)
      for (const std::string& backend : backends) {
        StabilityJob job{id, technique, transparency, backend};
        if (concerns(c, technique) && std::regex_search(jobName(job), wanted))
          jobs.push_back(std::move(job));
      }
  }
  return jobs;
}

report::StabilityRecord skippedStability(const StabilityJob& job, const std::string& why) {
  const StabilityCase& c = caseOf(job.caseId);
  return {.id = c.id,
          .title = c.title,
          .property = c.property,
          .reason = c.reason,
          .technique = nameOf(job.technique, job.transparency),
          .backend = job.backend,
          .parameter = c.parameter,
          .logarithmic = c.logarithmic,
          .curve = {},
          .breaksAt = {},
          .verdict = report::Verdict::Skipped,
          .why = why};
}

report::StabilityRecord runStability(const StabilityJob& job, const DeviceContext& device,
                                     const DeviceContext* other, bool quick) {
  const StabilityCase& c = caseOf(job.caseId);
  const CaseContext context{.device = device,
                            .other = other,
                            .technique = job.technique,
                            .transparency = job.transparency,
                            .quick = quick};
  const Knobs defaults = Knobs::resolve(knobsOf(context.info(), context.transparencyInfo()), {});
  if (auto why = unsupported(device.device, context.info(), context.transparencyInfo(), defaults))
    return skippedStability(job, why->reason);
  if (c.leavesOut)
    if (const std::string why = c.leavesOut(context); !why.empty())
      return skippedStability(job, why);
  report::StabilityRecord record = skippedStability(job, "");
  try {
    Found found = c.run(context);
    record.curve = std::move(found.curve);
    const TechniqueInfo& asked = c.ofShadows ? context.info() : context.transparencyInfo();
    if (const auto known = asked.breaksIn.find(c.id); known != asked.breaksIn.end())
      found.expected = known->second;
    report::judge(record, found.expected);
  } catch (const rhi::Error& error) {
    return skippedStability(job, error.what());
  }
  return record;
}

}  // namespace sb
