#include "base/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace base {
namespace {

/// Nothing unless all of the text was read.
template <class T>
std::optional<T> readAll(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

}  // namespace

bool allows(const NumberRule& rule, double value) {
  if (!std::isfinite(value) || value < rule.low || value > rule.high) return false;
  if (rule.above && value == rule.low) return false;
  if ((rule.whole || rule.odd) && std::floor(value) != value) return false;
  return !rule.odd || std::abs(std::fmod(value, 2.0)) == 1;
}

std::string describe(const NumberRule& rule) {
  const std::string kind = rule.odd ? "an odd number" : rule.whole ? "a whole number" : "a number";
  const NumberRule any;
  const bool low = rule.low != any.low, high = rule.high != any.high;
  if (low && high && !rule.above)
    return kind + " from " + numberText(rule.low) + " to " + numberText(rule.high);
  std::string text = kind;
  if (low) text += (rule.above ? " above " : " of at least ") + numberText(rule.low);
  if (high) text += (low ? " and at most " : " of at most ") + numberText(rule.high);
  return low || high ? text : kind + " that is finite";
}

std::optional<double> readNumber(std::string_view text, const NumberRule& rule) {
  const auto value = readAll<double>(text);
  if (!value || !allows(rule, *value)) return {};
  return *value + 0.0;
}

std::optional<uint64_t> readWhole(std::string_view text, uint64_t low, uint64_t high) {
  const auto value = readAll<uint64_t>(text);
  if (!value || *value < low || *value > high) return {};
  return value;
}

std::optional<std::pair<uint32_t, uint32_t>> readSize(std::string_view text) {
  const size_t x = text.find('x');
  if (x == text.npos) return {};
  const auto width = readWhole(text.substr(0, x), 1, kMaxPictureSide);
  const auto height = readWhole(text.substr(x + 1), 1, kMaxPictureSide);
  if (!width || !height) return {};
  return std::pair(uint32_t(*width), uint32_t(*height));
}

std::string numberText(double value) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, value).ptr);
}

}  // namespace base
