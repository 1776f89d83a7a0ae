// A camera's way to where it renders from: what the edit "motion" of a scene becomes.
#pragma once

#include "techniques/scene/scene.h"

namespace sb {

/// `steps` (two at least) frames of a camera that arrive at `end`, the last of them exactly: the
/// eye comes from `end - move` on a straight line at constant speed, while the camera turns evenly
/// about its own up axis by `turnDegrees` (counterclockwise as seen from above).
std::vector<glm::dmat4> cameraPath(const glm::dmat4& end, const glm::dvec3& move,
                                   double turnDegrees, uint32_t steps);

}  // namespace sb
