#include "suites/harness/selection.h"

#include <algorithm>
#include <regex>
#include <set>
#include <tuple>

#include "suites/scenes/procedural.h"
#include "techniques/common/error.h"
#include "techniques/common/registry.h"
#include "techniques/common/renderer.h"

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

struct Pair {
  const ShadowEntry* shadow;
  const TransparencyEntry* transparency;
  std::vector<KnobInfo> knobs() const { return knobsOf(shadow->info, transparency->info); }
};

std::vector<Pair> selectPairs(const Selection& selection) {
  std::vector<Pair> pairs;
  if (selection.techniques.empty())
    for (const ShadowEntry* t : shadowTechniques())
      pairs.push_back({t, &transparencyTechnique(kDefaultTransparency)});
  for (const std::string& name : selection.techniques) {
    const auto parts = split(name, '+');
    pairs.push_back({&shadowTechnique(parts[0]),
                     &transparencyTechnique(parts.size() > 1 ? parts[1] : kDefaultTransparency)});
  }
  return pairs;
}

struct Sweep {
  std::string knob;
  std::vector<std::string> values;
};

std::vector<Sweep> parseSweeps(const Selection& selection, const std::vector<Pair>& pairs) {
  std::set<std::string> known;
  for (const Pair& pair : pairs)
    for (const KnobInfo& knob : pair.knobs()) known.insert(knob.name);
  std::vector<Sweep> sweeps;
  for (const std::string& text : selection.sets) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals + 1 == text.size())
      throw InputError("--set", "found '" + text + "', expected knob=value[,value...]");
    Sweep sweep{text.substr(0, equals), split(text.substr(equals + 1), ',')};
    if (!known.contains(sweep.knob))
      throw InputError("--set", unknownName("knob", sweep.knob,
                                            std::vector(known.begin(), known.end())));
    sweeps.push_back(std::move(sweep));
  }
  return sweeps;
}

/// All combinations of the sweeps whose knobs the pair has.
std::vector<std::map<std::string, std::string>> combinations(const Pair& pair,
                                                             const std::vector<Sweep>& sweeps) {
  std::vector<std::map<std::string, std::string>> all = {{}};
  const auto knobs = pair.knobs();
  for (const Sweep& sweep : sweeps) {
    if (std::ranges::find(knobs, sweep.knob, &KnobInfo::name) == knobs.end()) continue;
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

std::regex parseFilter(const std::string& filter) {
  try {
    return std::regex(filter);
  } catch (const std::regex_error& e) {
    throw InputError("--filter", "'" + filter + "' is no regular expression: " + e.what());
  }
}

}  // namespace

const std::vector<std::string>& quickScenes() {
  static const std::vector<std::string> names = {"spheres_quads", "layers", "window", "teapot"};
  return names;
}

std::vector<CellId> selectCells(const Selection& selection,
                                const std::vector<std::string>& knownBackends,
                                const std::vector<std::string>& defaultBackends) {
  const auto pairs = selectPairs(selection);
  const auto sweeps = parseSweeps(selection, pairs);
  for (const std::string& b : selection.backends)
    if (std::ranges::find(knownBackends, b) == knownBackends.end())
      throw InputError("--backend", unknownName("backend", b, knownBackends));
  std::vector<std::string> scenes;
  for (const std::string& s : selection.scenes.empty() ? quickScenes() : selection.scenes)
    scenes.push_back(canonicalSceneSpec(s));
  const auto [width, height] = selection.size.value_or(std::pair<uint32_t, uint32_t>{512, 512});

  std::vector<CellId> cells;
  std::set<std::string> names;
  for (const std::string& scene : scenes)
    for (const Pair& pair : pairs)
      for (const auto& knobs : combinations(pair, sweeps))
        for (const std::string& backend :
             selection.backends.empty() ? defaultBackends : selection.backends) {
          CellId id{.technique = pair.shadow->info.name,
                    .transparency = pair.transparency->info.name,
                    .backend = backend,
                    .scene = scene,
                    .knobs = knobs,
                    .width = width,
                    .height = height,
                    .seed = selection.seed};
          if (names.insert(cellName(id)).second) cells.push_back(std::move(id));
        }
  if (!selection.filter.empty()) {
    const std::regex filter = parseFilter(selection.filter);
    std::vector<CellId> kept;
    for (CellId& id : cells)
      if (std::regex_search(cellName(id), filter)) kept.push_back(id);
    if (kept.empty())
      throw InputError("--filter", unknownName("filter", selection.filter,
                                               std::vector(names.begin(), names.end())));
    cells = std::move(kept);
  }
  return cells;
}

std::vector<std::vector<CellId>> groupCells(const std::vector<CellId>& cells, size_t most) {
  std::vector<std::vector<CellId>> groups;
  auto key = [](const CellId& c) { return std::tuple(c.scene, c.width, c.height, c.seed); };
  for (const CellId& cell : cells) {
    auto group = std::ranges::find_if(groups, [&](const auto& g) {
      return key(g.front()) == key(cell) && g.size() < most;
    });
    if (group == groups.end()) groups.push_back({cell});
    else group->push_back(cell);
  }
  for (auto& group : groups) {
    std::set<std::string> missing, present;
    for (const CellId& c : group) (c.technique == "none" ? present : missing).insert(c.backend);
    for (const std::string& backend : missing) {
      if (present.contains(backend)) continue;
      CellId baseline = group.front();
      baseline.technique = "none";
      baseline.transparency = kDefaultTransparency;
      baseline.backend = backend;
      baseline.knobs.clear();
      baseline.companion = true;
      group.push_back(std::move(baseline));
    }
  }
  return groups;
}

}  // namespace sb
