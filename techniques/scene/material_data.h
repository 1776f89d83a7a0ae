// A material as shaders see it, and as the optics of the truth see it.
#pragma once

#include "shaders/common/shared_types.h"
#include "techniques/scene/scene.h"

namespace sb {

/// The texture of a material at an index TEXTURE_* of shared_types.h.
const TextureSlot& textureSlot(const Material& material, uint32_t index);
gpu::MaterialData materialData(const Material& material);

}  // namespace sb
