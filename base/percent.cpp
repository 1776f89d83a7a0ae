#include "base/percent.h"

#include <cstdint>

namespace base {
namespace {

constexpr std::string_view kDigits = "0123456789ABCDEF";

/// 16 for what is none.
size_t hexDigit(char c) {
  const char upper = c >= 'a' && c <= 'f' ? char(c - 'a' + 'A') : c;
  const size_t value = kDigits.find(upper);
  return value == kDigits.npos ? 16 : value;
}

bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.';
}

}  // namespace

std::optional<std::string> percentDecoded(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    if (i + 2 >= text.size()) return {};
    const size_t high = hexDigit(text[i + 1]), low = hexDigit(text[i + 2]);
    if (high > 15 || low > 15) return {};
    out += char(high * 16 + low);
    i += 2;
  }
  return out;
}

std::string percentEncoded(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (isPlain(c))
      out += c;
    else
      out.append({'%', kDigits[uint8_t(c) >> 4], kDigits[uint8_t(c) & 15]});
  }
  return out;
}

}  // namespace base
