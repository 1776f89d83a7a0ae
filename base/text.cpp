#include "base/text.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

namespace base {
namespace {

struct Char {
  size_t bytes = 1;
  uint32_t code = 0;
  bool valid = false;
};

/// The character at the start of a text that is not empty. Overlong forms, halves of surrogate
/// pairs and what lies beyond Unicode are not valid.
Char firstOf(std::string_view text) {
  const auto at = [&](size_t i) { return uint32_t(static_cast<unsigned char>(text[i])); };
  const uint32_t lead = at(0);
  if (lead < 0x80) return {1, lead, true};
  const size_t bytes = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < bytes) return {};
  uint32_t code = lead & (0xFFu >> (bytes + 1));
  for (size_t i = 1; i < bytes; ++i) {
    if ((at(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (at(i) & 0x3F);
  }
  static constexpr uint32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[bytes] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {};
  return {bytes, code, true};
}

bool isPlain(const Char& c) {
  if (!c.valid || c.code < 0x20 || (c.code >= 0x7F && c.code < 0xA0)) return false;
  // Line and paragraph separators; marks, embeddings and isolates that change the direction.
  return !((c.code >= 0x2028 && c.code <= 0x202E) || (c.code >= 0x2066 && c.code <= 0x2069) ||
           c.code == 0x200E || c.code == 0x200F || c.code == 0x061C || c.code == 0xFEFF);
}

std::string hex(std::string_view bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string out;
  for (const unsigned char b : bytes) out += std::string("\\x") + kDigits[b >> 4] + kDigits[b & 15];
  return out;
}

bool isContinuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Where a character of valid text begins at or before `at`.
size_t boundary(std::string_view text, size_t at) {
  while (at > 0 && at < text.size() && isContinuation(text[at])) --at;
  return at;
}

}  // namespace

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const Char c = firstOf(text);
    if (!c.valid) return false;
    text.remove_prefix(c.bytes);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const Char c = firstOf(text);
    out += isPlain(c) ? std::string(text.substr(0, c.bytes)) : hex(text.substr(0, c.bytes));
    text.remove_prefix(c.bytes);
  }
  return out;
}

std::string printableLines(std::string_view text) {
  std::string out;
  for (size_t end; (end = text.find('\n')) != text.npos; text.remove_prefix(end + 1))
    out += printable(text.substr(0, end)) + "\n";
  return out + printable(text);
}

std::string shortened(std::string_view text, size_t most, std::string_view gap) {
  if (text.size() <= most) return std::string(text);
  if (most <= gap.size()) return std::string(gap.substr(0, most));
  const size_t head = (most - gap.size()) / 2;
  size_t last = text.size() - (most - gap.size() - head);
  while (last < text.size() && isContinuation(text[last])) ++last;
  return std::string(text.substr(0, boundary(text, head))).append(gap).append(text.substr(last));
}

std::string errorLine(std::string_view text) {
  return shortened(printable(text), kErrorLine, " ... ");
}

std::string counted(uint64_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many.empty() ? one + "s" : many);
}

std::string shellWord(std::string_view text) {
  if (printable(text) != text) {
    std::string out = "$'";
    while (!text.empty()) {
      const Char c = firstOf(text);
      const std::string_view bytes = text.substr(0, c.bytes);
      if (!isPlain(c))
        out += hex(bytes);
      else
        out += (bytes == "'" || bytes == "\\" ? "\\" : "") + std::string(bytes);
      text.remove_prefix(c.bytes);
    }
    return out + "'";
  }
  const bool plain = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
    return c >= 0x80 || std::isalnum(c) ||
           std::string_view("-_./:,=+@%^").find(char(c)) != std::string_view::npos;
  });
  if (plain) return std::string(text);
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace base
