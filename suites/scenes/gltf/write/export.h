// Scenes as GLB files that read back to the same scene.
#pragma once

#include <filesystem>

#include "techniques/scene/scene.h"

namespace sb {

/// Writes `scene` as one GLB: geometry, PNG images, materials, lights, cameras, media and what else
/// has no place in glTF under extras.shadowbench (EXTRAS.md). The file appears complete or not at
/// all. Reading it back with loadGltf() gives the same scene, with these exceptions: it is named by
/// the file, keys count anew, triangles without area are dropped, warnings are those of reading.
/// Throws InputError if the file cannot be written or a texture transform shears.
void exportGlb(const Scene& scene, const std::filesystem::path& path);

}  // namespace sb
