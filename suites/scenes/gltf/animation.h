// Where animated nodes stand at t = 0. Internal to the loader.
#pragma once

#include <optional>
#include <vector>

namespace sb {

/// What the first key of an animation says of a node, in place of the node's own properties.
struct NodePose {
  std::vector<double> translation, rotation,
      scale;                                   ///< as tinygltf keeps them; empty: not animated
  std::optional<std::vector<double>> weights;  ///< of morph targets
};

}  // namespace sb
