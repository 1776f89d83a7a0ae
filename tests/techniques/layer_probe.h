// Techniques of the tests that use what today's do not: receivers by layer, direct light of their
// own. Not registered: only tests that ask for them see them.
#pragma once

#include "techniques/render/registry.h"

namespace sb::test {

/// Answers, from a layer's depth alone, with the camera-relative position of its surface.
ShadowEntry positionProbe();
/// Answers 1 on the surfaces of one layer (ReceiverLayer::index), 0 on all others.
ShadowEntry chosenLayerProbe(uint32_t layer);
/// Replaces direct light by albedo x (1/4, roughness, steepness of the normal).
ShadowEntry directProbe();

}  // namespace sb::test
