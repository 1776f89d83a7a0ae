#include "techniques/render/frame_order.h"

#include <cassert>

namespace sb {

void recordInOrder(Frame& frame, ShadowTechnique* technique, const SurfaceDraws& draws, Maps maps) {
  const auto parts = technique ? technique->parts() : std::span<const std::vector<uint32_t>>{};
  if (technique && (maps == Maps::Record || !parts.empty())) technique->record(frame);
  draws.opaque();
  if (parts.empty() && draws.translucent) draws.translucent();
  if (!draws.translucentPart) return;
  for (size_t i = 0; i < parts.size(); ++i) {
    technique->recordPart(frame, i);
    draws.translucentPart(parts[i]);
  }
}

void recordLayer(Frame& frame, ShadowTechnique* technique, const ReceiverLayer& layer,
                 const LayerDraws& draws) {
  if (technique) {
    assert(technique->parts().empty() && "maps that change between surfaces answer no layer");
    draws.depth();
    technique->recordReceivers(frame, layer);
  }
  draws.surfaces();
}

}  // namespace sb
