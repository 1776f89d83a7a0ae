// Compressed geometry, unpacked before the model is read. Internal to the loader.
#pragma once

#include "suites/scenes/gltf/source/source.h"

namespace sb {

/// EXT_meshopt_compression: views that hold packed bytes come to point at unpacked ones.
void unpackBufferViews(GltfSource& source);
/// KHR_draco_mesh_compression: primitives come to use accessors of their own with unpacked data.
void unpackPrimitives(GltfSource& source);

}  // namespace sb
