// The list of techniques. Objects register themselves before main (link the techniques as an OBJECT
// library: an archive would drop them).
#pragma once

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "techniques/render/technique.h"

namespace sb {

template <class T>
struct Registered {
  TechniqueInfo info;
  std::function<std::unique_ptr<T>()> make;
};
using ShadowEntry = Registered<ShadowTechnique>;
using TransparencyEntry = Registered<TransparencyTechnique>;
using LightsEntry = Registered<LightTechnique>;

/// All registered, sorted by name, the baseline first.
std::vector<const ShadowEntry*> shadowTechniques();
std::vector<const TransparencyEntry*> transparencyTechniques();
std::vector<const LightsEntry*> lightTechniques();
/// The one that has no shadows.
const ShadowEntry& baselineTechnique();
/// Throws InputError with the nearest names.
const ShadowEntry& shadowTechnique(std::string_view name);
const TransparencyEntry& transparencyTechnique(std::string_view name);
const LightsEntry& lightTechnique(std::string_view name);

namespace detail {
bool add(ShadowEntry entry);
bool add(TransparencyEntry entry);
bool add(LightsEntry entry);
}  // namespace detail

/// Line at the end of a technique's file. `Type` derives from ShadowTechnique,
/// TransparencyTechnique or LightTechnique; what follows is its TechniqueInfo, whose commas are the
/// macro's too.
#define REGISTER_TECHNIQUE(Base, Type, ...)                        \
  [[maybe_unused]] const bool kRegistered##Type = sb::detail::add( \
      sb::Registered<sb::Base>{__VA_ARGS__, [] { return std::unique_ptr<sb::Base>(new Type); }})

}  // namespace sb
