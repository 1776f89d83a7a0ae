// A cell of the matrix as plain data. Running it depends on nothing else, so that it can be handed
// to another process or machine, and its name reproduces it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "techniques/plan/knobs.h"

namespace sb {

struct TechniqueInfo;

/// Of stochastic techniques, where nothing else is asked for.
inline constexpr uint32_t kDefaultSeeds = 64;

struct CellId {
  std::string technique;     ///< "CSSM2"
  std::string transparency;  ///< "Sorted"
  std::string backend;       ///< "vulkan", "opengl", "opengl-osmesa"
  std::string scene;         ///< canonical: "spheres_quads:quads=500" or a file's path
  std::map<std::string, std::string> knobs;  ///< those given; the rest are defaults
  uint32_t width = 512;
  uint32_t height = 512;
  uint32_t seed = 0;
  /// Measured for comparison only: not asked for, not reported.
  bool companion = false;
};

/// TECHNIQUE[+TRANSPARENCY]/backend/scene:params/knob:value.../WxH; default values left out; the
/// seed stands as "seed:N" among the knobs when it is not 0. Throws InputError on a bad knob.
std::string cellName(const CellId& id);

/// The cell that this one's cost is told against: the same without shadows.
CellId baselineOf(const CellId& id);

/// Knobs of the pair with the cell's values. Throws InputError.
Knobs cellKnobs(const CellId& id);

/// The command line that measures this cell again; `seeds`: over which noise is taken.
std::string cellCommand(const CellId& id, uint32_t seeds = kDefaultSeeds);

/// The transparency technique that names leave out.
inline constexpr const char* kDefaultTransparency = "Sorted";

/// The truth's tracer as a row of the comparison: on the CPU, whatever the backends; no knobs.
inline constexpr const char* kReferenceTechnique = "RayTraced";
inline constexpr const char* kReferenceBackend = "cpu";
inline bool isReference(const CellId& id) { return id.technique == kReferenceTechnique; }
/// What the reference is and its knobs, in the words of techniques.
const TechniqueInfo& referenceInfo();

}  // namespace sb
