// The one way in which text becomes a number: options, suites, parameters of scenes, knobs. All of
// the text counts, and nothing wraps, rounds or is ignored: "0x10", " 1", "1e400", "nan" are none.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace base {

/// What a number must be. Always finite.
struct NumberRule {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  bool above = false;  ///< `low` itself is excluded
  bool whole = false;
  bool odd = false;
};

bool allows(const NumberRule& rule, double value);

/// "a whole number from 1 to 65536", "a number above 0": after "expected" in the text of an error.
std::string describe(const NumberRule& rule);

/// The number, when all of `text` is one that the rule allows. -0 is 0.
std::optional<double> readNumber(std::string_view text, const NumberRule& rule);

/// Digits alone.
std::optional<uint64_t> readWhole(std::string_view text, uint64_t low, uint64_t high);

/// Largest width and height of a picture.
inline constexpr uint32_t kMaxPictureSide = 16384;
/// What `readSize` expects, for texts of errors.
inline constexpr const char* kSizeForm = "WIDTHxHEIGHT, each 1..16384";
/// "WIDTHxHEIGHT".
std::optional<std::pair<uint32_t, uint32_t>> readSize(std::string_view text);

/// The shortest text that reads back as the same number.
std::string numberText(double value);

}  // namespace base
