// A camera's way to where it renders from: what the edit "motion" of a scene becomes.
#pragma once

#include "techniques/scene/scene.h"

namespace sb {

/// `steps` (two at least) cameras that arrive at `end`, the last of them exactly: the eye comes
/// from `end - move` on a straight line at constant speed, while the camera turns evenly about its
/// own up axis by `turnDegrees` (counterclockwise as seen from above). All share the lens of `end`.
std::vector<Camera> cameraPath(const Camera& end, const glm::dvec3& move, double turnDegrees,
                               uint32_t steps);

}  // namespace sb
