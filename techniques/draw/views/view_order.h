// The order in which the camera meets whole instances: by the centre of the bounding box, as seed
// 000 sorts.
#pragma once

#include "techniques/draw/views/scene_view.h"

namespace sb {

/// Distance in front of the eye along the view direction, of a camera-relative point.
double viewDepth(const SceneView& view, const glm::dvec3& relative);
/// Farthest first; persistent keys break ties, so that the order of the file plays no part.
std::vector<uint32_t> backToFront(const SceneView& view, std::span<const uint32_t> instances);

}  // namespace sb
