// Visibility of a scene's lights as files: all of it in one OpenEXR file, a contact sheet to look
// at.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "backends/rhi/types.h"

namespace sb {

/// Pictures by light (an index into Scene::lights) and layer (0: the first opaque surface, 1.. from
/// the eye): RGB the share that arrives, alpha 1 where there is an answer: of the truth where
/// the light reaches the surface's side, of a technique on every surface.
/// kWithinMedia holds what arrives at points in media.
using VisibilityLayers = std::map<std::pair<uint32_t, uint32_t>, const std::vector<float>*>;

inline constexpr uint32_t kWithinMedia = UINT32_MAX;

/// PREFIX.visibility.exr and PREFIX.visibility.png.
std::vector<std::string> visibilityFiles(const std::string& prefix);

/// Writes them and says so. Layers that hold nothing (no alpha) are left out; without any other
/// nothing is written, and that is said. Layers of the file are `lightN.opaque`,
/// `lightN.layerM` and `lightN.media`. The sheet has for each light a row of the layers that any
/// light holds, for at most 1000 lights.
void writeVisibility(const std::string& prefix, rhi::Extent2D size, VisibilityLayers layers);

}  // namespace sb
