// Batches of translucent receivers that share one colour map (spec 05, variant B).
#pragma once

#include "techniques/partition/light_overlap.h"

namespace sb {

/// Splits `order` (instances as the camera draws them) greedily into runs such that in no view
///   (i)  one member lies before another, nor
///   (ii) a caster that lies before one member lies behind another: the map of the first would
///        darken the second, though the two need not overlap (overlap is not transitive).
/// A receiver that no order exists for is a run of its own.
std::vector<std::vector<uint32_t>> lightBatches(std::span<const uint32_t> order,
                                                const std::vector<LightOverlap>& views);

/// The casters of one view that lie before any of `members`, in scene order.
std::vector<uint32_t> castersBefore(const LightOverlap& view, std::span<const uint32_t> members);

}  // namespace sb
