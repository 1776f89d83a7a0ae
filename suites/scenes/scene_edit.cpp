#include "suites/scenes/scene_edit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/number.h"
#include "base/pattern.h"
#include "suites/scenes/bounds.h"
#include "suites/scenes/camera_path.h"
#include "suites/scenes/framing.h"
#include "suites/scenes/text.h"
#include "techniques/common/error.h"

namespace sb {
namespace {

struct Key {
  const char* name;
  size_t most;  ///< numbers; a colour may be given as one
  double low, high;
  bool required;
  bool text = false;  ///< a name rather than numbers
};

const std::vector<Key>& keysOf(const std::string& target, std::string_view firstKey) {
  static const std::vector<Key> kCamera = {{"eye", 3, -1e9, 1e9, true},
                                           {"at", 3, -1e9, 1e9, true},
                                           {"fov", 1, 1, 170, false}};
  static const std::vector<Key> kSun = {{"direction", 3, -1e9, 1e9, true},
                                        {"lux", 1, 0, 1e9, false}};
  static const std::vector<Key> kMotion = {{"move", 3, -1e9, 1e9, true},
                                           {"turn", 1, -360, 360, false},
                                           {"steps", 1, 2, 64, false}};
  static const std::vector<Key> kShownCamera = {{"show", 0, 0, 0, true, true}};
  static const std::vector<Key> kGround = {{"size", 1, 1e-3, 1e6, true}};
  static const std::vector<Key> kFile = {{"scene", 0, 0, 0, false, true},
                                         {"outside", 1, 0, 1, false}};
  static const std::vector<Key> kMaterial = {{"alpha", 1, 0, 1, true}, {"t", 3, 0, 1, false}};
  if (target == "camera" && firstKey == "show") return kShownCamera;
  return target == "camera"   ? kCamera
         : target == "ground" ? kGround
         : target == "file"   ? kFile
         : target == "sun"    ? kSun
         : target == "motion" ? kMotion
                              : kMaterial;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (size_t start = 0; start <= text.size();) {
    const size_t end = std::min(text.find(separator, start), text.size());
    parts.emplace_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

using base::numberText;

double parseNumber(const std::string& where, const Key& key, const std::string& text) {
  const base::NumberRule rule{.low = key.low, .high = key.high};
  const auto value = base::readNumber(text, rule);
  if (!value)
    throw InputError(where, std::string(key.name) + " holds '" + text + "', expected " +
                                base::describe(rule));
  return *value;
}

std::string decodedName(const std::string& where, const std::string& text) {
  std::string name;
  for (size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    if (text[i] != '%') {
      name += text[i];
      continue;
    }
    const char* digits = text.data() + i + 1;
    if (i + 2 >= text.size() || std::from_chars(digits, digits + 2, code, 16).ptr != digits + 2)
      throw InputError(where, "'" + text + "' needs two hexadecimal digits behind each '%'");
    name += char(code);
    i += 2;
  }
  return name;
}

SceneEdit parseEdit(const std::string& text) {
  const std::string where = "scene edit '" + text + "'";
  // Names of materials may hold colons; keys do not.
  const size_t equals = text.find('=');
  const size_t colon = equals == text.npos ? text.npos : text.rfind(':', equals);
  if (colon == text.npos || colon == 0)
    throw InputError(where, "expected camera:..., sun:..., motion:... or MATERIAL:key=value,... "
                            "(or ground:size=N, file:scene=NAME)");
  SceneEdit edit{.target = text.substr(0, colon), .values = {}, .names = {}};
  const std::vector<Key>& keys = keysOf(edit.target, text.substr(colon + 1, equals - colon - 1));
  const Key* key = nullptr;
  for (std::string item : split(std::string_view(text).substr(colon + 1), ',')) {
    if (const size_t at = item.find('='); at != item.npos) {
      const std::string name = item.substr(0, at);
      const auto found = std::ranges::find(keys, name, &Key::name);
      if (found == keys.end()) {
        std::vector<std::string> known;
        for (const Key& k : keys) known.emplace_back(k.name);
        throw InputError(where, unknownName("key", name, known));
      }
      const auto first = [](const auto& v) { return v.first; };
      if (std::ranges::find(edit.values, name, first) != edit.values.end() ||
          std::ranges::find(edit.names, name, first) != edit.names.end())
        throw InputError(where, name + " is given twice");
      key = &*found;
      if (key->text) {
        edit.names.push_back({name, encodedName(decodedName(where, item.substr(at + 1)))});
        continue;
      }
      edit.values.push_back({name, {}});
      item = item.substr(at + 1);
    }
    if (!key || key->text) throw InputError(where, "found '" + item + "', expected key=value");
    edit.values.back().second.push_back(parseNumber(where, *key, item));
  }
  for (const Key& k : keys) {
    if (k.text) {
      if (k.required && edit.names.empty()) throw InputError(where, std::string("lacks ") + k.name);
      continue;
    }
    const auto found = std::ranges::find(edit.values, k.name, [](auto& v) { return v.first; });
    if (found == edit.values.end()) {
      if (k.required) throw InputError(where, std::string("lacks ") + k.name);
      continue;
    }
    auto& numbers = found->second;
    if (std::string(k.name) == "t" && numbers.size() == 1) numbers.resize(3, numbers[0]);
    if (numbers.size() != k.most)
      throw InputError(where, std::string(k.name) + " has " + std::to_string(numbers.size()) +
                                  " numbers, expected " + std::to_string(k.most));
  }
  std::ranges::sort(edit.values, {}, [&](const auto& v) {
    return std::ranges::find(keys, v.first, &Key::name) - keys.begin();
  });
  return edit;
}

const std::vector<double>* find(const SceneEdit& edit, const std::string& key) {
  for (const auto& [name, numbers] : edit.values)
    if (name == key) return &numbers;
  return nullptr;
}

glm::dvec3 vectorOf(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

std::string nameOf(const SceneEdit& edit) { return "scene edit '" + canonicalEdits({edit}) + "'"; }

// The chosen camera comes first; the others keep their order.
void showCamera(Scene& scene, const SceneEdit& edit) {
  const std::string wanted = decodedName(nameOf(edit), edit.names.front().second);
  std::vector<std::string> names;
  for (const Camera& camera : scene.cameras) names.push_back(camera.name);
  auto found = std::ranges::find(names, wanted);
  const auto index = base::readWhole(wanted, 0, std::numeric_limits<uint32_t>::max());
  if (found == names.end() && index) {
    if (*index >= names.size())
      throw InputError(nameOf(edit), "there is no camera " + wanted + ", the scene has " +
                                         std::to_string(names.size()) + ", counted from 0");
    found = names.begin() + std::ptrdiff_t(*index);
  }
  if (found == names.end())
    throw InputError(nameOf(edit), unknownName("camera", printable(wanted), names));
  const auto at = scene.cameras.begin() + (found - names.begin());
  std::rotate(scene.cameras.begin(), at, at + 1);
}

void editCamera(Scene& scene, const SceneEdit& edit) {
  if (!edit.names.empty()) return showCamera(scene, edit);
  const glm::dvec3 eye = vectorOf(*find(edit, "eye")), at = vectorOf(*find(edit, "at"));
  if (eye == at) throw InputError(nameOf(edit), "eye and at are the same point");
  const Bounds bounds = sceneBox(scene);
  const double farthest =
      bounds.empty() ? 1000 : glm::length(bounds.center() - eye) + bounds.radius();
  Camera camera;
  camera.name = "edit";
  camera.toWorld = lookFrom(eye, at);
  if (const auto* fov = find(edit, "fov")) camera.fovY = (*fov)[0] * std::numbers::pi / 180;
  camera.farPlane = farthest * 1.01;
  camera.nearPlane = camera.farPlane * 1e-4;
  scene.cameras.insert(scene.cameras.begin(), camera);
  std::erase(scene.warnings, kCameraAdded);
}

void editSun(Scene& scene, const SceneEdit& edit) {
  const glm::dvec3 direction = vectorOf(*find(edit, "direction"));
  if (glm::length(direction) == 0) throw InputError(nameOf(edit), "the direction has no length");
  Light light = defaultLight();
  light.name = "sun";
  light.direction = glm::normalize(direction);
  if (const auto* lux = find(edit, "lux")) light.intensity = float((*lux)[0]);
  scene.lights = {light};
  // The sky came with the sun that is replaced; the file's own stays.
  if (std::erase(scene.warnings, kLightAdded) > 0) scene.sky = glm::vec3(0);
}

void editMotion(Scene& scene, const SceneEdit& edit) {
  const glm::dvec3 move = vectorOf(*find(edit, "move"));
  const auto* turn = find(edit, "turn");
  const auto* steps = find(edit, "steps");
  const double degrees = turn ? (*turn)[0] : 0, count = steps ? (*steps)[0] : 8;
  if (move == glm::dvec3(0) && degrees == 0)
    throw InputError(nameOf(edit), "the camera neither moves nor turns");
  if (count != std::floor(count))
    throw InputError(nameOf(edit), "steps holds '" + numberText(count) + "', expected a whole number");
  scene.path = cameraPath(scene.camera(), move, degrees, uint32_t(count));
}

void editMaterials(Scene& scene, const SceneEdit& edit) {
  size_t matched = 0;
  std::vector<std::string> names;
  const base::Pattern wanted = base::Pattern::glob(edit.target);
  for (Material& m : scene.materials) {
    names.push_back(m.name);
    if (!wanted.found(m.name)) continue;
    ++matched;
    m.opticsOverride = true;
    m.overrideAlpha = float((*find(edit, "alpha"))[0]);
    const auto* t = find(edit, "t");
    m.overrideTransmission = t ? glm::vec3(vectorOf(*t)) : glm::vec3(0);
  }
  if (matched == 0) throw InputError(nameOf(edit), unknownName("material", edit.target, names));
}

}  // namespace

GltfOptions fileOptions(const std::vector<SceneEdit>& edits, bool isFile) {
  GltfOptions options;
  for (const SceneEdit& edit : edits) {
    if (edit.target != "file") continue;
    if (!edit.names.empty()) {
      if (!isFile) throw InputError(nameOf(edit), "is of glTF files, but the scene is none");
      options.scene = decodedName(nameOf(edit), edit.names.front().second);
    }
    if (const auto* outside = find(edit, "outside")) options.allowOutside = (*outside)[0] != 0;
  }
  return options;
}

std::string encodedName(std::string_view name) {
  std::string text;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '_' || c == '-' || c == '.';
    constexpr char kDigits[] = "0123456789ABCDEF";
    if (plain)
      text += c;
    else
      text.append({'%', kDigits[uint8_t(c) >> 4], kDigits[uint8_t(c) & 15]});
  }
  return text;
}

std::vector<SceneEdit> parseEdits(std::string_view text) {
  std::vector<SceneEdit> edits;
  for (const std::string& part : split(text, ';')) edits.push_back(parseEdit(part));
  return edits;
}

std::string canonicalEdits(const std::vector<SceneEdit>& edits) {
  std::string out;
  for (const SceneEdit& edit : edits) {
    out += (out.empty() ? "" : ";") + edit.target;
    char separator = ':';
    for (const auto& [name, text] : edit.names) {
      out += separator + name + "=" + text;
      separator = ',';
    }
    for (const auto& [name, numbers] : edit.values) {
      out += separator + name;
      char before = '=';
      for (const double n : numbers) {
        out += before + numberText(n);
        before = ',';
      }
      separator = ',';
    }
  }
  return out;
}

void applyEdits(Scene& scene, const std::vector<SceneEdit>& edits) {
  // Cameras see what is added, wherever it stands in the list.
  for (const SceneEdit& edit : edits)
    if (edit.target == "ground") addGround(scene, (*find(edit, "size"))[0]);
  for (const SceneEdit& edit : edits) {
    if (edit.target == "ground" || edit.target == "file") continue;
    if (edit.target == "camera")
      editCamera(scene, edit);
    else if (edit.target == "sun")
      editSun(scene, edit);
    else if (edit.target == "motion")
      continue;
    else
      editMaterials(scene, edit);
  }
  // The way leads to where the camera stands in the end, wherever the edit stands in the list.
  for (const SceneEdit& edit : edits)
    if (edit.target == "motion") editMotion(scene, edit);
}

}  // namespace sb
