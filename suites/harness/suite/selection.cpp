#include "suites/harness/suite/selection.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  size_t start = 0;
  for (size_t end; (end = text.find(separator, start)) != std::string::npos; start = end + 1)
    parts.push_back(text.substr(start, end - start));
  parts.push_back(text.substr(start));
  return parts;
}

/// Cells of which only the techniques are known.
std::vector<CellId> selectTechniques(const Selection& selection) {
  std::vector<CellId> all;
  for (const std::string& name : selection.techniques) all.push_back(parseTechniques(name));
  if (!all.empty()) return all;
  for (const ShadowEntry* t : shadowTechniques()) all.push_back({.technique = t->info.name});
  all.push_back({.technique = referenceInfo().name});
  return all;
}

/// Backends of their cells among those asked for (empty: the default ones).
std::vector<std::string> backendsOf(const CellId& techniques, const Selection& selection,
                                    const std::vector<std::string>& defaults) {
  std::vector<std::string> list = selection.backends.empty() ? defaults : selection.backends;
  const bool asked = std::erase(list, kTracerBackend) > 0 || selection.backends.empty();
  if (!isReference(techniques)) return list;
  const auto isNamed = std::ranges::find(selection.techniques, referenceInfo().name);
  if (asked || isNamed != selection.techniques.end()) return {kTracerBackend};
  return {};
}

struct Sweep {
  std::string knob;
  std::vector<std::string> values;
};

/// Names of all that have a knob, for people.
std::string techniquesWith(const std::string& knob) {
  std::string names;
  const auto add = [&](const TechniqueInfo& info) {
    if (std::ranges::find(info.knobs, knob, &KnobInfo::name) != info.knobs.end())
      names += (names.empty() ? "" : ", ") + info.name;
  };
  for (const ShadowEntry* t : shadowTechniques()) add(t->info);
  for (const TransparencyEntry* t : transparencyTechniques()) add(t->info);
  for (const LightsEntry* t : lightTechniques()) add(t->info);
  add(referenceInfo());
  return names;
}

std::vector<Sweep> parseSweeps(const Selection& selection, const std::vector<CellId>& techniques) {
  std::set<std::string> known;
  for (const CellId& id : techniques)
    for (const KnobInfo& knob : knobInfosOf(id)) known.insert(knob.name);
  std::vector<Sweep> sweeps;
  for (const std::string& text : selection.sets) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals + 1 == text.size())
      throw InputError("--set", "found '" + text + "', expected knob=value[,value...]");
    Sweep sweep{text.substr(0, equals), split(text.substr(equals + 1), ',')};
    if (const std::string others = known.contains(sweep.knob) ? "" : techniquesWith(sweep.knob);
        !others.empty())
      throw InputError("--set", "found '" + sweep.knob + "', which is a knob of " + others +
                                    ", not of the techniques that are asked for");
    if (!known.contains(sweep.knob))
      throw InputError("--set",
                       unknownName("knob", sweep.knob, std::vector(known.begin(), known.end())));
    if (std::ranges::find(sweeps, sweep.knob, &Sweep::knob) != sweeps.end())
      throw InputError(
          "--set", "found the knob " + sweep.knob + " twice, expected all its values in one list");
    sweeps.push_back(std::move(sweep));
  }
  return sweeps;
}

/// Lists of values multiply.
void requireBounded(size_t cells) {
  if (cells > kMostCells)
    throw InputError("selection", "found more than " + std::to_string(kMostCells) +
                                      " cells, expected fewer values in its lists");
}

/// All combinations of the sweeps whose knobs the techniques have.
std::vector<std::map<std::string, std::string>> combinations(const CellId& techniques,
                                                             const std::vector<Sweep>& sweeps) {
  std::vector<std::map<std::string, std::string>> all = {{}};
  const auto knobs = knobInfosOf(techniques);
  for (const Sweep& sweep : sweeps) {
    if (std::ranges::find(knobs, sweep.knob, &KnobInfo::name) == knobs.end()) continue;
    requireBounded(all.size() * sweep.values.size());
    std::vector<std::map<std::string, std::string>> next;
    for (const auto& base : all)
      for (const std::string& value : sweep.values) {
        next.push_back(base);
        next.back()[sweep.knob] = value;
      }
    all = std::move(next);
  }
  return all;
}

/// Edit distance of `pattern` to the nearest part of `text`, whatever stands around that part.
size_t partDistance(std::string_view pattern, std::string_view text) {
  std::vector<size_t> row(text.size() + 1, 0);
  for (size_t i = 1; i <= pattern.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= text.size(); ++j) {
      const size_t substitute = diagonal + (pattern[i - 1] == text[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return *std::ranges::min_element(row);
}

std::string noMatch(const std::string& filter, const std::vector<std::string>& names) {
  std::vector<std::pair<size_t, std::string>> ranked;
  for (const std::string& name : names) ranked.emplace_back(partDistance(filter, name), name);
  std::ranges::stable_sort(ranked, {}, &std::pair<size_t, std::string>::first);
  std::string text = "found '" + filter + "', which no cell's name matches; nearest: ";
  for (size_t i = 0; i < std::min<size_t>(3, ranked.size()); ++i)
    text += (i ? ", " : "") + ranked[i].second;
  return text;
}

std::string withEdits(const std::string& scene, const std::vector<std::string>& edits) {
  std::string spec = scene;
  for (const std::string& edit : edits) spec = withEdit(spec, edit);
  return spec;
}

}  // namespace

base::Pattern parseFilter(const std::string& filter) {
  try {
    return base::Pattern::regex(filter);
  } catch (const std::invalid_argument& e) {
    throw InputError("--filter", "'" + filter + "' is no regular expression: " + e.what());
  }
}

NameFilter::NameFilter(const Selection& selection, const std::vector<std::string>& names)
    : m_all(selection.filter.empty()) {
  if (m_all) return;
  const std::string& filter = selection.filter;
  const bool isName = std::ranges::find(names, filter) != names.end();
  std::set<std::string> matched;
  for (const std::string& name : names)
    if (isName ? name == filter : name.find(filter) != name.npos) matched.insert(name);
  if (!isName) {
    try {
      const base::Pattern wanted = parseFilter(filter);
      for (const std::string& name : names)
        if (wanted.found(name)) matched.insert(name);
    } catch (const InputError&) {
      if (matched.empty()) throw;
    }
  }
  for (const std::string& name : names)
    if (matched.contains(name) != selection.filterExcludes) m_kept.insert(name);
  if (m_kept.empty())
    throw InputError("--filter", selection.filterExcludes
                                     ? "every cell's name matches '" + filter +
                                           "', which is to be left out"
                                     : noMatch(filter, names));
}

const std::vector<std::string>& quickScenes() {
  static const std::vector<std::string> names = {"spheres_quads", "layers", "window", "teapot"};
  return names;
}

std::vector<std::string> namedScenes(const Selection& selection) {
  std::vector<std::string> scenes;
  for (const std::string& s : selection.scenes)
    scenes.push_back(canonicalSceneSpec(withEdits(s, selection.edits)));
  return scenes;
}

void requireKnownBackends(const std::vector<std::string>& backends,
                          std::vector<std::string> known) {
  known.push_back(kTracerBackend);
  for (const std::string& b : backends)
    if (std::ranges::find(known, b) == known.end())
      throw InputError("--backend", unknownName("backend", b, known));
}

std::vector<CellId> selectCells(const Selection& selection,
                                const std::vector<std::string>& knownBackends,
                                const std::vector<std::string>& defaultBackends) {
  const auto techniques = selectTechniques(selection);
  const auto sweeps = parseSweeps(selection, techniques);
  requireKnownBackends(selection.backends, knownBackends);
  Selection shown = selection;
  if (shown.scenes.empty()) shown.scenes = quickScenes();
  const std::vector<std::string> scenes = namedScenes(shown);
  const auto [width, height] = selection.size.value_or(std::pair<uint32_t, uint32_t>{512, 512});

  std::vector<CellId> cells;
  std::set<CellId> known;
  for (const std::string& scene : scenes)
    for (const CellId& drawn : techniques)
      for (const auto& knobs : combinations(drawn, sweeps))
        for (const std::string& backend : backendsOf(drawn, selection, defaultBackends)) {
          CellId id = withKnobs(drawn, knobs);
          id.backend = backend;
          id.scene = scene;
          id.width = width;
          id.height = height;
          id.seed = selection.seed;
          if (known.insert(id).second) cells.push_back(std::move(id));
          requireBounded(cells.size());
        }
  return filterCells(selection, cells);
}

std::vector<CellId> filterCells(const Selection& selection, const std::vector<CellId>& cells) {
  std::vector<std::string> names;
  for (const CellId& id : cells) names.push_back(cellName(id));
  const NameFilter filter(selection, names);
  std::vector<CellId> kept;
  for (size_t i = 0; i < cells.size(); ++i)
    if (filter.keeps(names[i])) kept.push_back(cells[i]);
  return kept;
}

void addBaselines(std::vector<GroupCell>& group) {
  std::set<CellId> present;
  for (const GroupCell& c : group) present.insert(c.id);
  for (size_t i = 0, asked = group.size(); i < asked; ++i) {
    if (isReference(group[i].id) || group[i].companion) continue;
    CellId baseline = baselineOf(group[i].id);
    if (present.insert(baseline).second) group.push_back({std::move(baseline), true});
  }
}

std::vector<std::vector<GroupCell>> groupCells(const std::vector<CellId>& cells, size_t most) {
  // A cell on all its backends stays together: their pictures and times are compared.
  std::vector<std::vector<CellId>> families;
  std::map<CellId, size_t> familyOf;
  for (const CellId& cell : cells) {
    const auto [it, isNew] = familyOf.try_emplace(onAnyBackend(cell), families.size());
    if (isNew) families.emplace_back();
    families[it->second].push_back(cell);
  }
  auto key = [](const CellId& c) { return std::tuple(c.scene, c.width, c.height, c.seed); };
  std::vector<std::vector<GroupCell>> groups;
  for (const auto& family : families) {
    auto group = std::ranges::find_if(groups, [&](const auto& g) {
      return key(g.front().id) == key(family.front()) && g.size() + family.size() <= most;
    });
    if (group == groups.end()) group = groups.insert(groups.end(), std::vector<GroupCell>());
    group->insert(group->end(), family.begin(), family.end());
  }
  for (auto& group : groups) addBaselines(group);
  return groups;
}

}  // namespace sb
