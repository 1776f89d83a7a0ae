// Which part of the picture a light of finite range may reach (spec 07, culling: scissor).
#pragma once

#include <optional>

#include "backends/rhi/types.h"
#include "techniques/scene/tree/region.h"

namespace sb {

/// Pixels that hold whatever the camera sees of a sphere (relative to the eye); nothing where that
/// is the whole picture. Row 0 is that of clip y = -1.
std::optional<rhi::Rect> sphereRectangle(const Camera& camera, rhi::Extent2D size,
                                         const Sphere& sphere);

}  // namespace sb
