// Knobs: the settings of a technique that trade accuracy for cost, declared as data and checked in
// one place. A value is kept as canonical text, so that the name of a cell is unique.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sb {

/// What a knob is. Exactly one of `choices` (a word) and min/max (a number) describes its range.
struct KnobInfo {
  std::string name;
  std::string unit;  ///< "texels", "bits", "" for words
  std::string help;
  std::string fallback;              ///< default value, canonical
  std::vector<std::string> choices;  ///< words allowed
  double min = 0;
  double max = 0;
  bool integer = true;
  bool odd = false;                ///< only odd numbers
  std::vector<std::string> sweep;  ///< values of an accuracy-cost sweep, cheapest first
};

/// Values of all knobs of a cell.
class Knobs {
 public:
  /// Defaults of `infos`, then `given`; throws InputError on an unknown knob or a bad value.
  static Knobs resolve(const std::vector<KnobInfo>& infos,
                       const std::map<std::string, std::string>& given);

  const std::string& text(std::string_view name) const;
  bool is(std::string_view name, std::string_view value) const { return text(name) == value; }
  uint32_t integer(std::string_view name) const;
  float number(std::string_view name) const;
  const std::map<std::string, std::string, std::less<>>& all() const { return m_values; }
  /// Names and values of those that differ from their defaults, in declaration order.
  const std::vector<std::pair<std::string, std::string>>& changed() const { return m_changed; }

 private:
  std::map<std::string, std::string, std::less<>> m_values;
  std::vector<std::pair<std::string, std::string>> m_changed;
};

}  // namespace sb
