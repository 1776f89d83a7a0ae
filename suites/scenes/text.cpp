#include "suites/scenes/text.h"

#include <cstdint>

namespace sb {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// Length of the character that begins `text` and its code; 0 if it is no UTF-8.
size_t decode(std::string_view text, uint32_t& code) {
  const auto byte = [&](size_t i) { return uint32_t(uint8_t(text[i])); };
  const uint32_t first = byte(0);
  const size_t length = first < 0x80                     ? 1
                        : first >= 0xC2 && first < 0xE0  ? 2
                        : first >= 0xE0 && first < 0xF0  ? 3
                        : first >= 0xF0 && first <= 0xF4 ? 4
                                                         : 0;
  if (length == 0 || length > text.size()) return 0;
  code = length == 1 ? first : first & (0x7Fu >> length);
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  return code < kLeast[length] || surrogate || code > 0x10FFFF ? 0 : length;
}

bool shows(uint32_t c) {
  const bool control = c < 0x20 || (c >= 0x7F && c < 0xA0);
  const bool direction = c == 0x061C || c == 0x200E || c == 0x200F ||
                         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
  return !control && !direction && c != 0xFEFF;
}

bool isContinuation(char c) { return (uint8_t(c) & 0xC0) == 0x80; }

}  // namespace

std::string printable(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    uint32_t code = 0;
    const size_t length = decode(text, code);
    if (length > 0 && shows(code))
      out += text.substr(0, length);
    else
      out += kReplacement;
    text.remove_prefix(std::max<size_t>(length, 1));
  }
  return out;
}

std::string shortened(std::string_view text, size_t most) {
  if (text.size() <= most) return std::string(text);
  if (most <= 3) return std::string(std::string_view("...").substr(0, most));
  size_t head = (most - 3) / 2, tail = text.size() - (most - 3 - head);
  while (head > 0 && isContinuation(text[head])) --head;
  while (tail < text.size() && isContinuation(text[tail])) ++tail;
  return std::string(text.substr(0, head)).append("...").append(text.substr(tail));
}

void cleanNames(Scene& scene) {
  const auto clean = [](auto& list) {
    for (auto& item : list) item.name = printable(item.name);
  };
  scene.name = printable(scene.name);
  clean(scene.images);
  clean(scene.materials);
  clean(scene.meshes);
  clean(scene.instances);
  clean(scene.lights);
  clean(scene.media);
  clean(scene.cameras);
  for (std::string& warning : scene.warnings) warning = printable(warning);
}

}  // namespace sb
