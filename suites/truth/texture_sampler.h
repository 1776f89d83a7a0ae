// Textures as the rasteriser samples them at LOD 0 (decision D9): texel centres at half integers,
// bilinear or nearest, wrapped per axis, sRGB decoded before filtering.
#pragma once

#include "techniques/scene/scene.h"

namespace sb {

/// RGBA, linear, of a slot that is present. `uv` before the slot's transform.
glm::dvec4 sampleTexture(const Scene& scene, const TextureSlot& slot, const glm::dvec2& uv);

}  // namespace sb
