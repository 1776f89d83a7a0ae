// The table of rules that glTF's JSON is checked against. Internal to the checks.
#pragma once

#include <cfloat>
#include <cmath>
#include <span>
#include <vector>

namespace sb::gltf {

enum class Kind { UInt, Number, Bool, String, Object, Numbers, Index, Indices };

struct Rule {
  const char* owner;  ///< objects that hold the property
  const char* key;
  Kind kind;
  bool required = false;
  double low = -INFINITY;  ///< of UInt, Number, Numbers
  double high = INFINITY;
  const char* target = nullptr;  ///< of Index, Indices: top-level array
  size_t count = 0;              ///< of Numbers: length
};

constexpr bool kRequired = true;
constexpr double kInf = INFINITY;

/// Paths: "meshes[].primitives[]" is every primitive.
const std::vector<Rule>& rules();
/// Where textures stand; each may carry KHR_texture_transform.
std::span<const char* const> textureInfos();

inline Rule index(const char* owner, const char* key, const char* target, bool required = false) {
  return {owner, key, Kind::Index, required, 0, kInf, target};
}
/// Numbers that become floats: what would be infinite there is refused here.
inline Rule number(const char* owner, const char* key, double low = -FLT_MAX) {
  return {owner, key, Kind::Number, false, low, FLT_MAX};
}
inline Rule numbers(const char* owner, const char* key, size_t count, double most = FLT_MAX) {
  return {owner, key, Kind::Numbers, false, -most, most, nullptr, count};
}

}  // namespace sb::gltf
