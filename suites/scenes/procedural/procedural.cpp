// The registry of procedural scenes and the specs that name them.
#include "suites/scenes/procedural/procedural.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/number.h"
#include "suites/scenes/edit/scene_edit.h"
#include "suites/scenes/edit/world_path.h"
#include "suites/scenes/gltf/loader.h"
#include "suites/scenes/procedural/scenes.h"
#include "techniques/plan/error.h"
#include "techniques/scene/box.h"
#include "techniques/scene/placed_scene.h"

namespace sb {
namespace {

const std::vector<ProceduralScene>& registry() {
  static const std::vector<ProceduralScene> kScenes = [] {
    std::vector<ProceduralScene> scenes = {layers(), panes(),      penumbra(), spheresQuads(),
                                           teapot(), roseWindow(), fog(),      mine(),
                                           yard(),   library(),    wedges()};
    for (ProceduralScene& scene : scenes) scene.info.params.push_back(circlingParam());
    return scenes;
  }();
  return kScenes;
}

bool isFile(std::string_view spec) {
  const auto ends = [&](std::string_view end) {
    return spec.size() >= end.size() &&
           std::ranges::equal(spec.substr(spec.size() - end.size()), end, {},
                              [](unsigned char c) { return char(std::tolower(c)); });
  };
  return ends(".gltf") || ends(".glb");
}

struct SplitSpec {
  std::string_view base;
  std::vector<SceneEdit> edits;
};

/// Where the edits begin: the '?' behind the name, or the end. Procedural scenes hold none in their
/// names; files may: of the places where a '?' follows a file's ending, the last one before which a
/// file stands counts, else the first.
size_t baseLength(std::string_view spec) {
  size_t first = spec.npos, existing = spec.npos;
  for (size_t at = 0; at <= spec.size(); ++at) {
    if ((at < spec.size() && spec[at] != '?') || !isFile(spec.substr(0, at))) continue;
    if (first == spec.npos) first = at;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(spec.substr(0, at), ignored)) existing = at;
  }
  if (existing != spec.npos) return existing;
  if (first != spec.npos) return first;
  return std::min(spec.find('?'), spec.size());
}

SplitSpec splitSpec(std::string_view spec) {
  const size_t length = baseLength(spec);
  if (length == spec.size()) return {spec, {}};
  return {spec.substr(0, length), parseEdits(spec.substr(length + 1))};
}

std::string valueText(const SceneParam& param, double value) {
  return param.choices.empty() ? base::numberText(value) : param.choices.at(size_t(value));
}

double parseValue(const std::string& where, const SceneParam& param, const std::string& text) {
  if (!param.choices.empty()) {
    const auto found = std::ranges::find(param.choices, text);
    if (found == param.choices.end())
      throw InputError(where, unknownName("value of " + param.name, text, param.choices));
    return double(found - param.choices.begin());
  }
  const base::NumberRule rule{.low = param.low, .high = param.high, .whole = param.whole};
  const auto value = base::readNumber(text, rule);
  if (!value)
    throw InputError(where, param.name + " is '" + text + "', expected " + base::describe(rule) +
                                (param.unit.empty() ? "" : " " + param.unit));
  return *value;
}

struct Parsed {
  const ProceduralScene* scene = nullptr;
  ParamValues values;
};

Parsed parseSpec(std::string_view spec) {
  const std::string where = "scene '" + std::string(spec) + "'";
  const std::string name(spec.substr(0, spec.find(':')));
  Parsed parsed;
  std::vector<std::string> names;
  for (const ProceduralScene& scene : registry()) {
    names.push_back(scene.info.name);
    if (scene.info.name == name) parsed.scene = &scene;
  }
  if (!parsed.scene)
    throw InputError(where,
                     unknownName("scene", name, names) + " (or a path that ends in .gltf or .glb)");
  const std::vector<SceneParam>& params = parsed.scene->info.params;
  for (const SceneParam& param : params) parsed.values[param.name] = param.fallback;
  if (name.size() == spec.size()) return parsed;

  std::vector<std::string> given;
  std::string_view rest = spec.substr(name.size() + 1);
  while (true) {
    const std::string item(rest.substr(0, rest.find(',')));
    const size_t equals = item.find('=');
    if (equals == item.npos)
      throw InputError(where, "'" + item + "' is not of the form parameter=value");
    const std::string key = item.substr(0, equals);
    const auto param = std::ranges::find(params, key, &SceneParam::name);
    if (param == params.end()) {
      std::vector<std::string> known;
      for (const SceneParam& p : params) known.push_back(p.name);
      throw InputError(where, unknownName("parameter of " + name, key, known));
    }
    if (std::ranges::find(given, key) != given.end())
      throw InputError(where, key + " is given twice");
    given.push_back(key);
    parsed.values[key] = parseValue(where, *param, item.substr(equals + 1));
    if (item.size() == rest.size()) return parsed;
    rest.remove_prefix(item.size() + 1);
  }
}

std::string canonical(const Parsed& parsed) {
  std::string spec = parsed.scene->info.name;
  char separator = ':';
  for (const SceneParam& param : parsed.scene->info.params) {
    const double value = parsed.values.at(param.name);
    if (value == param.fallback) continue;
    spec += separator + param.name + "=" + valueText(param, value);
    separator = ',';
  }
  return spec;
}

void moveWorld(Scene& scene, const Parsed& parsed, uint32_t steps) {
  if (parsed.scene->move) parsed.scene->move(scene, parsed.values, steps);
  const double degrees = parsed.values.at("circling");
  for (uint32_t l = 0; degrees > 0 && l < scene.lights.size(); ++l)
    moveLight(scene, l, lightCircle(scene.lights[l], sceneBox(scene).center(), degrees, steps));
}

}  // namespace

std::string SceneParam::fallbackText() const { return valueText(*this, fallback); }

std::vector<SceneInfo> proceduralScenes() {
  std::vector<SceneInfo> infos;
  for (const ProceduralScene& scene : registry()) infos.push_back(scene.info);
  return infos;
}

Scene makeScene(std::string_view spec) {
  const auto [base, edits] = splitSpec(spec);
  Scene scene;
  const bool file = isFile(base);
  const GltfOptions options = fileOptions(edits, file);
  if (file) {
    scene = loadGltf(base, options);
    applyEdits(scene, edits);
  } else {
    const Parsed parsed = parseSpec(base);
    scene = parsed.scene->make(parsed.values);
    scene.name = canonical(parsed);
    applyEdits(scene, edits);
    moveWorld(scene, parsed, options.steps);
  }
  requireMotion(scene, edits);
  if (scene.cameras.size() > 1 && scene.camera().name != "edit")
    scene.warnings.push_back("the scene holds " + std::to_string(scene.cameras.size()) +
                             " cameras; the picture shows '" + scene.camera().name +
                             "' (--camera NAME|INDEX shows another)");
  for (uint32_t i = 0; i < scene.lights.size(); ++i) scene.lights[i].key = i;
  return scene;
}

std::string withEdit(std::string_view spec, std::string_view edit) {
  const bool first = baseLength(spec) == spec.size();
  return std::string(spec).append(first ? "?" : ";").append(edit);
}

std::string canonicalSceneSpec(std::string_view spec) {
  const auto [base, edits] = splitSpec(spec);
  const std::string name = isFile(base) ? std::string(base) : canonical(parseSpec(base));
  return edits.empty() ? name : name + "?" + canonicalEdits(edits);
}

}  // namespace sb
