// Ways of things other than the camera, closed: each arrives where it stands and begins anew.
#pragma once

#include "techniques/scene/scene.h"

namespace sb {

/// `steps` (two at least) places of a light that goes round the vertical axis through `center`,
/// `degrees` in all at constant speed, counterclockwise as seen from above. It faces the axis as it
/// does in the end.
std::vector<LightPose> lightCircle(const Light& light, const glm::dvec3& center, double degrees,
                                   uint32_t steps);

/// `steps` (two at least) places of something that goes round a circle at constant speed and turns
/// with it. `frame`: the circle's first axis points from its middle to `end`, its third is normal
/// to it.
std::vector<glm::dmat4> circlePath(const glm::dmat4& end, const glm::dmat3& frame, double radius,
                                   uint32_t steps);

}  // namespace sb
