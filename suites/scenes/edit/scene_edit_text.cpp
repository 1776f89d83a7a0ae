// The text of edits: which keys each has, what they may hold, and the one way to write them again.
#include <algorithm>

#include "base/number.h"
#include "base/percent.h"
#include "base/text.h"
#include "suites/scenes/edit/scene_edit.h"
#include "techniques/plan/error.h"

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
  static const std::vector<Key> kCamera = {
      {"eye", 3, -1e9, 1e9, true}, {"at", 3, -1e9, 1e9, true}, {"fov", 1, 1, 170, false}};
  static const std::vector<Key> kSun = {{"direction", 3, -1e9, 1e9, true},
                                        {"lux", 1, 0, 1e9, false}};
  static const std::vector<Key> kMotion = {{"move", 3, -1e9, 1e9, false},
                                           {"turn", 1, -360, 360, false},
                                           {"steps", 1, 2, 64, false},
                                           {"animation", 0, 0, 0, false, true}};
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

double parseNumber(const std::string& where, const Key& key, const std::string& text) {
  const base::NumberRule rule{.low = key.low, .high = key.high};
  const auto value = base::readNumber(text, rule);
  if (!value)
    throw InputError(
        where, std::string(key.name) + " holds '" + text + "', expected " + base::describe(rule));
  return *value;
}

std::string decodedName(const std::string& where, const std::string& text) {
  auto name = base::percentDecoded(text);
  if (!name) throw InputError(where, "'" + text + "' needs two hexadecimal digits behind each '%'");
  return *std::move(name);
}

/// An option that asks for an edit, and how it is written.
struct EditOption {
  const char* prefix;  ///< of the edit's text; what follows is the option's value
  const char* option;
  const char* form;
};

const EditOption& optionOf(const std::string& text) {
  static const EditOption kOptions[] = {
      {"camera:show=", "--camera", "NAME, INDEX or eye=X,Y,Z,at=X,Y,Z[,fov=DEG]"},
      {"camera:", "--camera", "NAME, INDEX or eye=X,Y,Z,at=X,Y,Z[,fov=DEG]"},
      {"sun:", "--sun", "direction=X,Y,Z[,lux=E]"},
      {"motion:", "--motion", "[move=X,Y,Z][,turn=DEG][,animation=NAME|INDEX][,steps=N]"},
      {"file:scene=", "--gltf-scene", "NAME or INDEX"},
      {"file:outside=", "--allow-outside", "no value"},
      {"ground:", "--ground", "no value"},
      {"", "--set-material", "GLOB:alpha=A[,t=R,G,B]"}};
  return *std::ranges::find_if(kOptions, [&](const EditOption& o) { return text.starts_with(o.prefix); });
}

/// An edit as its user wrote it; names of cells and suites hold edits too.
std::string whereOf(const std::string& text) {
  const EditOption& o = optionOf(text);
  const std::string value = text.substr(std::string_view(o.prefix).size());
  return std::string(o.option) + " '" + base::percentDecoded(value).value_or(value) + "'";
}

std::string formOf(const std::string& text) { return optionOf(text).form; }

SceneEdit parseEdit(const std::string& text) {
  const std::string where = whereOf(text);
  // Names of materials may hold colons; keys do not.
  const size_t equals = text.find('=');
  const size_t colon = equals == text.npos ? text.npos : text.rfind(':', equals);
  if (colon == text.npos || colon == 0)
    throw InputError(where, "expected " + formOf(text));
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
        edit.names.push_back({name, base::percentEncoded(decodedName(where, item.substr(at + 1)))});
        continue;
      }
      edit.values.push_back({name, {}});
      item = item.substr(at + 1);
    }
    if (!key || key->text) throw InputError(where, "found '" + item + "', expected " + formOf(text));
    edit.values.back().second.push_back(parseNumber(where, *key, item));
  }
  for (const Key& k : keys) {
    if (k.text) {
      if (k.required && edit.names.empty()) throw InputError(where, std::string("lacks ") + k.name);
      continue;
    }
    const auto found = std::ranges::find(edit.values, k.name, [](auto& v) { return v.first; });
    if (found == edit.values.end()) {
      if (k.required)
        throw InputError(where, std::string("lacks ") + k.name + ", expected " + formOf(text));
      continue;
    }
    auto& numbers = found->second;
    if (std::string(k.name) == "t" && numbers.size() == 1) numbers.resize(3, numbers[0]);
    if (numbers.size() != k.most)
      throw InputError(where, std::string(k.name) + " has " + base::counted(numbers.size(), "number") +
                                  ", expected " + std::to_string(k.most));
  }
  std::ranges::sort(edit.values, {}, [&](const auto& v) {
    return std::ranges::find(keys, v.first, &Key::name) - keys.begin();
  });
  return edit;
}

}  // namespace

const std::vector<double>* SceneEdit::find(std::string_view key) const {
  for (const auto& [name, numbers] : values)
    if (name == key) return &numbers;
  return nullptr;
}

std::string SceneEdit::where() const { return whereOf(canonicalEdits({*this})); }

std::string SceneEdit::name() const { return decodedName(where(), names.front().second); }

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
        out += before + base::numberText(n);
        before = ',';
      }
      separator = ',';
    }
  }
  return out;
}

}  // namespace sb
