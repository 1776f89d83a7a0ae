#include "tests/fuzz/mutate.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/scenes/gltf_json.h"

namespace sb::fuzz {
namespace {

using nlohmann::json;

size_t below(Random& random, size_t count) { return count == 0 ? 0 : size_t(random() % count); }
bool oneIn(Random& random, size_t n) { return below(random, n) == 0; }

json interesting(Random& random) {
  static const json kValues = {0,
                               1,
                               -1,
                               2,
                               3,
                               4,
                               5120,
                               5121,
                               5123,
                               5125,
                               5126,
                               255,
                               256,
                               65535,
                               65536,
                               1e5,
                               1e7,
                               1e9,
                               4e9,
                               1e18,
                               1e38,
                               1e39,
                               1e300,
                               -1e300,
                               1e-300,
                               1e-40,
                               0.5,
                               -0.5,
                               2.5,
                               2147483647,
                               2147483648u,
                               4294967295u,
                               18446744073709551615u,
                               "",
                               "x",
                               "MASK",
                               "BLEND",
                               "MAT4",
                               "VEC3",
                               "SCALAR",
                               "CUBICSPLINE",
                               "../x.bin",
                               "a%00",
                               "data:,",
                               "data:application/octet-stream;base64,AAAAAAAAAAAAAAAA",
                               "\x1b[2J",
                               nullptr,
                               true,
                               false,
                               json::array(),
                               json::object(),
                               {0, 0, 0},
                               {0, 0, 0, 0},
                               {1e300, 1, 1},
                               {0}};
  return kValues[below(random, kValues.size())];
}

void collect(json& at, std::vector<json*>& all) {
  all.push_back(&at);
  if (at.is_structured())
    for (json& child : at) collect(child, all);
}

void flipBytes(std::string& bytes, Random& random) {
  if (bytes.empty()) return;
  for (size_t n = 1 + below(random, 4); n > 0; --n) {
    const size_t at = below(random, bytes.size());
    switch (below(random, 6)) {
      case 0:
        bytes[at] = char(random());
        break;
      case 1:
        bytes[at] = char(bytes[at] ^ (1 << below(random, 8)));
        break;
      case 2:
        bytes[at] = char(oneIn(random, 2) ? 0xFF : 0);
        break;
      case 3:
        bytes.erase(at, 1 + below(random, 8));
        break;
      case 4:
        bytes.insert(at, bytes.substr(below(random, bytes.size()), below(random, 16)));
        break;
      default: {
        const float values[] = {NAN, INFINITY, -INFINITY, 1e38f, -0.0f, 1e-40f};
        const float value = values[below(random, 6)];
        if (at + 4 <= bytes.size()) std::memcpy(bytes.data() + at, &value, 4);
      }
    }
    if (bytes.empty()) return;
  }
}

std::string decoded64(const std::string& text) {
  std::string out;
  uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int v = c >= 'A' && c <= 'Z'   ? c - 'A'
                  : c >= 'a' && c <= 'z' ? c - 'a' + 26
                  : c >= '0' && c <= '9' ? c - '0' + 52
                  : c == '+'             ? 62
                  : c == '/'             ? 63
                                         : -1;
    if (v < 0) break;
    bits = bits << 6 | uint32_t(v);
    if ((count += 6) >= 8) out += char(bits >> (count -= 8));
  }
  return out;
}

// Bytes behind a data uri: attributes, pictures, packed streams.
void changeData(json& value, Random& random) {
  std::string text = value.get<std::string>();
  const size_t comma = text.find(";base64,");
  if (comma == text.npos) return;
  std::string bytes = decoded64(text.substr(comma + 8));
  flipBytes(bytes, random);
  value = text.substr(0, comma + 8) + test::base64(bytes);
}

void changeValue(json& document, const json& other, Random& random) {
  std::vector<json*> all;
  collect(document, all);
  json& at = *all[below(random, all.size())];
  switch (below(random, 8)) {
    case 0:
    case 1:
      at = interesting(random);
      return;
    case 2:  // leave something out
      if (at.is_object() && !at.empty())
        at.erase(std::next(at.begin(), std::ptrdiff_t(below(random, at.size()))).key());
      if (at.is_array() && !at.empty()) at.erase(below(random, at.size()));
      return;
    case 3:  // once more
      if (at.is_array() && !at.empty()) at.push_back(json(at[below(random, at.size())]));
      return;
    case 4: {  // what stands elsewhere
      const json copy = *all[below(random, all.size())];
      if (copy.size() < 200) at = copy;
      return;
    }
    case 5:  // from another file, where it stands there
      if (at.is_object() && other.is_object() && !other.empty()) {
        const auto from = std::next(other.begin(), std::ptrdiff_t(below(random, other.size())));
        at[from.key()] = from.value();
      }
      return;
    case 6:
      if (at.is_number()) {
        const int step = int(below(random, 9)) - 4;
        if (at.is_number_integer()) at = at.get<int64_t>() + step;
        if (at.is_number_float()) at = at.get<double>() * step;
      }
      return;
    default:
      for (int tries = 0; tries < 20; ++tries) {
        json& string = *all[below(random, all.size())];
        if (string.is_string()) return changeData(string, random);
      }
  }
}

struct Parts {
  std::string json, binary;
  bool glb = false;
};

Parts split(const std::string& file) {
  Parts parts;
  if (file.size() < 20 || file.compare(0, 4, "glTF") != 0) return {.json = file, .binary = ""};
  uint32_t length = 0;
  std::memcpy(&length, file.data() + 12, 4);
  parts.glb = true;
  parts.json = file.substr(20, length);
  if (file.size() > 28 + size_t(length)) parts.binary = file.substr(28 + length);
  return parts;
}

std::string joined(Parts parts) {
  if (!parts.glb) return parts.json;
  while (parts.json.size() % 4) parts.json += ' ';
  while (parts.binary.size() % 4) parts.binary += '\0';
  const auto word = [](size_t value) {
    const uint32_t w = uint32_t(value);
    return std::string(reinterpret_cast<const char*>(&w), 4);
  };
  std::string file = word(parts.json.size()) + "JSON" + parts.json;
  if (!parts.binary.empty())
    file += word(parts.binary.size()) + std::string("BIN\0", 4) + parts.binary;
  return "glTF" + word(2) + word(12 + file.size()) + file;
}

}  // namespace

std::string mutated(const std::string& seed, const std::string& other, Random& random) {
  if (oneIn(random, 10)) {  // blind
    std::string file = seed;
    flipBytes(file, random);
    return file;
  }
  Parts parts = split(seed);
  if (parts.glb && oneIn(random, 3)) {
    flipBytes(parts.binary, random);
    return joined(parts);
  }
  json document = json::parse(parts.json, nullptr, false);
  if (document.is_discarded()) return seed;
  const json foreign = json::parse(split(other).json, nullptr, false);
  for (size_t n = 1 + below(random, 3); n > 0; --n) changeValue(document, foreign, random);
  parts.json = document.dump(-1, ' ', false, json::error_handler_t::ignore);
  if (oneIn(random, 8)) flipBytes(parts.json, random);
  return joined(parts);
}

std::string asGlb(const std::string& gltf) {
  json document = json::parse(gltf);
  json& buffer = document["buffers"][0];
  const std::string uri = buffer["uri"];
  buffer.erase("uri");
  return joined({document.dump(), decoded64(uri.substr(uri.find(',') + 1)), true});
}

}  // namespace sb::fuzz
