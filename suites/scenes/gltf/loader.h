// glTF 2.0 and GLB files as scenes. What is read, what is ignored and what is refused: EXTRAS.md.
#pragma once

#include <filesystem>

#include "suites/scenes/gltf/source/source.h"
#include "techniques/scene/scene.h"

namespace sb {

/// Loads a file, told apart by content. The scene is named by the file's stem. It has at least one
/// camera and one light: what the file lacks is added (a framing camera, a sun and a sky), and said
/// in Scene::warnings, as is everything mended or left out and which of several scenes is shown.
/// Animations are posed at t = 0, skins and morph targets applied; one that is to play moves nodes
/// along Scene::path, and shapes stay. Names and warnings hold no control
/// characters. Throws InputError for a file that is broken, too large or
/// requires what is not supported; the text names file, field, what was found and expected. No
/// other exception escapes.
Scene loadGltf(const std::filesystem::path& path, const GltfOptions& options = {});

}  // namespace sb
