// What a run may take of the machine's memory, and whether what it is to make fits.
#pragma once

#include "backends/rhi/types.h"
#include "suites/cli/options/options.h"
#include "techniques/scene/scene.h"

namespace sb {

/// --max-memory, or half of the machine's, for everything that follows.
void limitMemory(const Options& options);

/// What is made of a scene. `Files`: the visibility of all lights is written, which needs memory
/// of its own.
enum class Made : uint8_t { Picture, VisibilityFiles, Truth, TruthFiles };

/// Throws InputError with the figure when a scene, or what is to be made of it, does not fit.
void requireMemory(const Scene& scene, rhi::Extent2D size, Made made);

}  // namespace sb
