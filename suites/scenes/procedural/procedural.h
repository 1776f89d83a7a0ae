// Scenes made by code: deterministic by seed, scaled by documented parameters. A spec names one:
//   "layers", "spheres_quads:quads=500,orientation=random", or the path of a .gltf or .glb file;
//   behind '?' changes of camera, light and materials (suites/scenes/edit/scene_edit.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "techniques/scene/scene.h"

namespace sb {

/// One parameter of a procedural scene: a number, a whole number or one of `choices`.
struct SceneParam {
  std::string name;
  std::string unit;          ///< "" if it has none
  double fallback = 0;       ///< default; of choices: its index
  double low = 0, high = 0;  ///< range, both included; of choices: unused
  bool whole = false;
  std::vector<std::string> choices;
  std::string help;
  /// The default as it is written in a spec.
  std::string fallbackText() const;
};

struct SceneInfo {
  std::string name;
  std::string help;
  std::vector<SceneParam> params;
};

/// All procedural scenes, by name.
std::vector<SceneInfo> proceduralScenes();

/// Makes the scene that `spec` names; Scene::name is its canonical spec (of a file: its stem).
/// Throws InputError for unknown scenes and parameters (naming the nearest), values that are no
/// numbers or out of range, parameters given twice, and what loadGltf() throws.
Scene makeScene(std::string_view spec);

/// `spec` with one more edit behind it.
std::string withEdit(std::string_view spec, std::string_view edit);

/// `spec` with parameters in their documented order, default values left out: equal for equal
/// scenes. A file's path stays as it is. Throws like makeScene(), but reads no file.
std::string canonicalSceneSpec(std::string_view spec);

}  // namespace sb
