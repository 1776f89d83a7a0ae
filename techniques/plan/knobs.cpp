#include "techniques/plan/knobs.h"

#include <algorithm>
#include <cassert>
#include <cstdio>

#include "base/number.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

std::string canonicalNumber(const KnobInfo& info, const std::string& text) {
  const base::NumberRule rule{
      .low = info.min, .high = info.max, .whole = info.integer, .odd = info.odd};
  const auto value = base::readNumber(text, rule);
  if (!value)
    throw InputError("knob " + info.name,
                     "found '" + text + "', expected " + base::describe(rule));
  char out[32];
  std::snprintf(out, sizeof out, "%.9g", *value);
  return out;
}

}  // namespace

Knobs Knobs::resolve(const std::vector<KnobInfo>& infos,
                     const std::map<std::string, std::string>& given) {
  Knobs knobs;
  for (const KnobInfo& info : infos) {
    assert(!knobs.m_values.contains(info.name) && "a knob is declared once");
    knobs.m_values[info.name] = info.fallback;
  }
  for (const auto& [name, text] : given) {
    auto info = std::ranges::find(infos, name, &KnobInfo::name);
    if (info == infos.end()) {
      std::vector<std::string> names;
      for (const KnobInfo& i : infos) names.push_back(i.name);
      throw InputError("", unknownName("knob", name, names));
    }
    if (info->choices.empty()) {
      knobs.m_values[name] = canonicalNumber(*info, text);
    } else {
      if (std::ranges::find(info->choices, text) == info->choices.end())
        throw InputError("knob " + name, unknownName("value", text, info->choices));
      knobs.m_values[name] = text;
    }
  }
  for (const KnobInfo& info : infos)
    if (knobs.m_values[info.name] != info.fallback)
      knobs.m_changed.emplace_back(info.name, knobs.m_values[info.name]);
  return knobs;
}

const std::string& Knobs::text(std::string_view name) const {
  auto it = m_values.find(name);
  assert(it != m_values.end() && "a technique asks only for knobs that it declares");
  return it->second;
}

// As numbers, for a whole one may read "1e+09".
uint32_t Knobs::integer(std::string_view name) const {
  return uint32_t(base::readNumber(text(name), {.low = 0, .high = UINT32_MAX, .whole = true}).value());
}

float Knobs::number(std::string_view name) const {
  return float(base::readNumber(text(name), {}).value());
}

}  // namespace sb
