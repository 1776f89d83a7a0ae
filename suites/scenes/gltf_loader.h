// glTF 2.0 and GLB files as scenes. What is read, what is ignored and what is refused: EXTRAS.md.
#pragma once

#include <filesystem>

#include "techniques/common/scene.h"

namespace sb {

/// Loads a file, told apart by content. The scene is named by the file's stem. It has at least one
/// camera and one light: what the file lacks is added, and said in Scene::warnings, as is
/// everything mended or left out. Throws InputError for a file that is broken, too large or
/// requires what is not supported; the text names file, field, what was found and expected. No
/// other exception escapes.
Scene loadGltf(const std::filesystem::path& path);

}  // namespace sb
