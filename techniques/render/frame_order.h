// The order of a frame, whatever its surfaces are drawn for: the picture or the visibility buffer;
// and of each layer of receivers within it.
#pragma once

#include <functional>
#include <span>

#include "techniques/render/technique.h"

namespace sb {

/// What is drawn between the passes of a shadow technique. Absent: nothing is.
struct SurfaceDraws {
  std::function<void()> opaque;
  std::function<void()> translucent;  ///< all, where one set of maps serves them
  std::function<void(std::span<const uint32_t>)> translucentPart;  ///< those that share maps
};

enum class Maps : uint8_t {
  Record,  ///< made by this frame
  Stand,   ///< as an earlier frame left them, where none changes within a frame
};

/// Maps, opaque surfaces, then translucent ones; where maps change between these, part by part.
/// `technique` may be null.
void recordInOrder(Frame& frame, ShadowTechnique* technique, const SurfaceDraws& draws,
                   Maps maps = Maps::Record);

/// A layer of receivers: its depth, what the technique makes of it, then its surfaces.
struct LayerDraws {
  std::function<void()> depth;
  std::function<void()> surfaces;
};

/// `technique` null: one that does not answer by layers, for which no depth is drawn beforehand.
void recordLayer(Frame& frame, ShadowTechnique* technique, const ReceiverLayer& layer,
                 const LayerDraws& draws);

}  // namespace sb
