#include "techniques/common/knobs.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "techniques/common/error.h"

namespace sb {
namespace {

std::string rangeText(const KnobInfo& info) {
  char text[96];
  std::snprintf(text, sizeof text, "%s%s between %g and %g", info.odd ? "an odd " : "a ",
                info.integer ? "whole number" : "number", info.min, info.max);
  return text;
}

std::string canonicalNumber(const KnobInfo& info, const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = !info.integer || value == std::floor(value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
      value < info.min || value > info.max || !whole ||
      (info.odd && std::fmod(value, 2.0) != 1.0))
    throw InputError("knob " + info.name, "found '" + text + "', expected " + rangeText(info));
  char out[32];
  std::snprintf(out, sizeof out, "%.9g", value);
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
      knobs.m_changed.push_back(info.name + ":" + knobs.m_values[info.name]);
  return knobs;
}

const std::string& Knobs::text(std::string_view name) const {
  auto it = m_values.find(name);
  assert(it != m_values.end() && "a technique asks only for knobs that it declares");
  return it->second;
}

uint32_t Knobs::integer(std::string_view name) const { return uint32_t(std::stoul(text(name))); }

float Knobs::number(std::string_view name) const { return std::stof(text(name)); }

std::string Knobs::nameSuffix() const {
  std::string out;
  for (const std::string& part : m_changed) out += (out.empty() ? "" : "/") + part;
  return out;
}

}  // namespace sb
