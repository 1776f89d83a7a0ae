// A cell of the matrix as a value: what is asked for, and nothing of what is found. It has an
// order, so that it is the key of whatever belongs to a cell; its name is made from it and is never
// taken apart again.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {

/// What names leave out: the technique of its kind that is meant where none is named.
inline constexpr const char* kDefaultTransparency = "Sorted";
inline constexpr const char* kDefaultLights = "AllLights";

/// The backend of the truth's tracer: the CPU, whatever the APIs.
inline constexpr const char* kTracerBackend = "cpu";

struct CellId {
  std::string technique;                            ///< "CSSM2"
  std::string transparency = kDefaultTransparency;  ///< "DepthPeeling"
  std::string lights = kDefaultLights;              ///< the loop over lights
  std::string backend;                              ///< "vulkan", "opengl", "opengl-osmesa"
  std::string scene;  ///< canonical: "spheres_quads:quads=500" or a file's path
  /// Names and values of those that are not at their defaults, in the order of their declaration;
  /// values canonical.
  std::vector<std::pair<std::string, std::string>> knobs;
  uint32_t width = 512;
  uint32_t height = 512;
  uint32_t seed = 0;

  auto operator<=>(const CellId&) const = default;
};

/// TECHNIQUE[+TRANSPARENCY][@LIGHTS], defaults left out.
std::string techniqueName(const std::string& technique, const std::string& transparency,
                          const std::string& lights);
std::string techniqueName(const CellId& id);

/// TECHNIQUE[+TRANSPARENCY][@LIGHTS]/backend/scene:params/knob:value.../WxH; default values left
/// out; the seed stands as "seed:N" behind the knobs when it is not 0. Fit for a line of a
/// terminal.
std::string cellName(const CellId& id);

/// What a row of the results is.
enum class Role : uint8_t {
  Technique,
  Baseline,  ///< without shadows: what costs are told against
  Tracer,    ///< the truth's own, on the CPU: it joins the rows of every backend
};
inline constexpr Role kRoles[] = {Role::Technique, Role::Baseline, Role::Tracer};
std::string_view roleName(Role role);  ///< "technique", "baseline", "tracer"

}  // namespace report
