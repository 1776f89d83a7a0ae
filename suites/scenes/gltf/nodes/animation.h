// Animations of nodes. Internal to the loader.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sb {

struct GltfContext;

/// What an animation says of a node at one time, in place of the node's own properties.
struct NodePose {
  std::vector<double> translation, rotation,
      scale;                                   ///< as tinygltf keeps them; empty: not animated
  std::optional<std::vector<double>> weights;  ///< of morph targets
};

/// What an animation does to one property of a node.
struct AnimationChannel {
  size_t node = 0;
  std::string path;                                 ///< "translation" ..; not checked
  nlohmann::json sampler;                           ///< an object
  std::string samplerField = {}, targetField = {};  ///< for errors
};

/// Channels that have a node, of the animation that plays, else of the first; none where the file
/// has no animation. Fails where it has not the one that is asked for.
std::vector<AnimationChannel> animationChannels(const GltfContext& context);

/// A required member of an object.
const nlohmann::json& memberOf(const GltfContext& context, const nlohmann::json& object,
                               const std::string& field, const char* key);

}  // namespace sb
