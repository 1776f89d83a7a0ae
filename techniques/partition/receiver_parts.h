// Translucent receivers in parts, each of which gets a shadow map of its own between the camera's
// draws (spec 05, variants S and B): which receivers, and which casters of each light view.
#pragma once

#include "techniques/maps/shadow_maps.h"

namespace sb {

struct ReceiverParts {
  std::vector<std::vector<uint32_t>> receivers;             ///< by part, in the order of drawing
  std::vector<std::vector<std::vector<uint32_t>>> casters;  ///< by part and light view
};

/// The source's partition: each mesh alone, with all whose centres are nearer to the light.
ReceiverParts meshParts(const Context& context, const ShadowMaps& maps);

/// Batches of receivers that may share a map, see light_batches.h.
ReceiverParts batchParts(const SceneView& view, const ShadowMaps& maps);

}  // namespace sb
