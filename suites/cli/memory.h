// What a run may take of the machine's memory, and whether what it is to make fits.
#pragma once

#include "backends/rhi/types.h"
#include "suites/cli/options.h"
#include "techniques/common/scene.h"

namespace sb {

/// --max-memory, or half of the machine's, for everything that follows.
void limitMemory(const Options& options);

/// Throws InputError with the figure when a scene, a picture of it or (asked for) its truth does
/// not fit.
void requireMemory(const Scene& scene, rhi::Extent2D size, bool truth);

}  // namespace sb
