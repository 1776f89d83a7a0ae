#include "reports/html/elements/text.h"

#include <fmt/format.h>

#include <cmath>

namespace report {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Length of the UTF-8 sequence that starts `text`, or 0 when there is none.
size_t sequenceLength(std::string_view text) {
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
  size_t length = 0;
  uint32_t code = 0, least = 0;
  if (byte(0) < 0x80) return 1;
  if ((byte(0) & 0xE0) == 0xC0)
    length = 2, code = byte(0) & 0x1Fu, least = 0x80;
  else if ((byte(0) & 0xF0) == 0xE0)
    length = 3, code = byte(0) & 0x0Fu, least = 0x800;
  else if ((byte(0) & 0xF8) == 0xF0)
    length = 4, code = byte(0) & 0x07u, least = 0x10000;
  if (length == 0 || length > text.size()) return 0;
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3Fu);
  }
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return code < least || code > 0x10FFFF || surrogate ? 0 : length;
}

/// "1.2e-5", "1e-6"
std::string scientific(double value) {
  std::string text = fmt::format("{:.1e}", value);
  const size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  if (mantissa.ends_with(".0")) mantissa.resize(mantissa.size() - 2);
  return mantissa + "e" + std::to_string(std::stoi(text.substr(e + 1)));
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (size_t i = 0; i < text.size();) {
    const size_t length = sequenceLength(text.substr(i));
    const char c = text[i];
    if (length == 0 ||
        (length == 1 && static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') ||
        c == 0x7F)
      out += kReplacement;
    else if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\'')
      out += "&#39;";
    else
      out += text.substr(i, length);
    i += length == 0 ? 1 : length;
  }
  return out;
}

std::string scriptJson(const Json& json) {
  std::string out;
  for (char c : json.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (c == '<')
      out += "\\u003c";
    else if (c == '>')
      out += "\\u003e";
    else if (c == '&')
      out += "\\u0026";
    else
      out += c;
  }
  return out;
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t word = 0;
    for (size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k)
      out += i + k > bytes.size() ? '=' : kDigits[word >> (18 - 6 * k) & 63];
  }
  return out;
}

std::string base64OfHex(std::string_view hex) {
  std::string bytes;
  for (size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += char(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
  return base64(bytes);
}

std::string figure(double value) {
  const double size = std::abs(value);
  if (value == 0) return "0";
  if (size >= 99.95) return fmt::format("{:.0f}", value);
  if (size < 9.995e-5) return scientific(value);
  return fmt::format("{:.3g}", value);
}

std::string figure(const std::optional<double>& value) { return value ? figure(*value) : "–"; }

std::string percent(double share) { return figure(100 * share) + " %"; }

std::string mebibytes(uint64_t bytes) {
  const double value = double(bytes) / (1 << 20);
  return value < 0.095 ? figure(value) : fmt::format("{:.1f}", value);
}

std::string withInterval(double value, double low, double high) {
  return figure(value) + " [" + figure(low) + ", " + figure(high) + "]";
}

}  // namespace report
