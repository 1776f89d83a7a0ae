// How translucent casters of a light view are spread over maps (spec 05): levels of the overlap
// graph, what cannot be ordered and is peeled, and which map each receiver reads.
#pragma once

#include "techniques/partition/graph_levels.h"
#include "techniques/partition/light_overlap.h"
#include "techniques/partition/light_peel.h"

namespace sb {

struct LightLevels {
  /// Casters by level. A receiver of level j reads the colour behind levels 0..j-1.
  std::vector<std::vector<uint32_t>> casters;
  /// Casters by level that have no order among themselves, peeled for one another.
  std::vector<std::vector<uint32_t>> peeled;
  /// Of each node (see LightOverlap): its instance, level, and whether it reads peeled layers.
  struct Receiver {
    uint32_t instance = 0;
    uint32_t level = 0;
    bool peeled = false;
  };
  std::vector<Receiver> receivers;
};

/// Levels of an overlap graph. At most `cap` levels: whatever would lie on a later one is peeled on
/// the last. Surfaces on a cycle, and those that may shadow themselves, are peeled on their level.
LightLevels lightLevels(const LightOverlap& overlap, uint32_t cap);

/// One level on which everything is peeled.
LightLevels onePeeledLevel(const LightOverlap& overlap);

}  // namespace sb
