#include "techniques/render/registry.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "techniques/plan/error.h"

namespace sb {
namespace {

template <class T>
std::map<std::string, Registered<T>, std::less<>>& table() {
  static std::map<std::string, Registered<T>, std::less<>> entries;
  return entries;
}

template <class T>
std::vector<const Registered<T>*> sorted() {
  std::vector<const Registered<T>*> list;
  for (const auto& [name, entry] : table<T>()) list.push_back(&entry);
  std::ranges::stable_partition(list, [](auto* e) { return e->info.baseline; });
  return list;
}

template <class T>
const Registered<T>& find(std::string_view kind, std::string_view name) {
  auto it = table<T>().find(name);
  if (it != table<T>().end()) return it->second;
  std::vector<std::string> names;
  for (const auto& [key, entry] : table<T>()) names.push_back(key);
  throw InputError("", unknownName(kind, name, names));
}

}  // namespace

std::vector<const ShadowEntry*> shadowTechniques() { return sorted<ShadowTechnique>(); }
std::vector<const TransparencyEntry*> transparencyTechniques() {
  return sorted<TransparencyTechnique>();
}
std::vector<const LightsEntry*> lightTechniques() { return sorted<LightTechnique>(); }
const ShadowEntry& baselineTechnique() {
  const ShadowEntry& first = *shadowTechniques().front();
  assert(first.info.baseline && "one technique says that it is the baseline");
  return first;
}
const ShadowEntry& shadowTechnique(std::string_view name) {
  return find<ShadowTechnique>("technique", name);
}
const TransparencyEntry& transparencyTechnique(std::string_view name) {
  return find<TransparencyTechnique>("transparency technique", name);
}
const LightsEntry& lightTechnique(std::string_view name) {
  return find<LightTechnique>("light technique", name);
}

namespace detail {
bool add(ShadowEntry entry) {
  auto name = entry.info.name;
  return table<ShadowTechnique>().emplace(std::move(name), std::move(entry)).second;
}
bool add(TransparencyEntry entry) {
  auto name = entry.info.name;
  return table<TransparencyTechnique>().emplace(std::move(name), std::move(entry)).second;
}
bool add(LightsEntry entry) {
  auto name = entry.info.name;
  return table<LightTechnique>().emplace(std::move(name), std::move(entry)).second;
}
}  // namespace detail

}  // namespace sb
