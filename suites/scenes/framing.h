// A camera and a light for scenes that bring none.
#pragma once

#include "suites/scenes/bounds.h"

namespace sb {

/// Camera frame at `eye` that looks at `target`, y up as far as possible.
glm::dmat4 lookFrom(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up = glm::dvec3(0, 1, 0));
/// A perspective camera, in front, above and to the right of `box`, that sees all of it in pictures
/// at least as wide as high; near and far planes enclose it.
Camera framingCamera(const Bounds& box);
/// What a scene's warnings say when one of the two was added; void once an edit sets its own.
inline constexpr const char* kCameraAdded =
    "the file shows no camera; one that frames the whole scene was added";
inline constexpr const char* kLightAdded =
    "the file shows no light; a white directional one was added";
/// White, from above the viewer's left shoulder; a white diffuse surface that faces it gets
/// radiance 1 (illuminance pi).
Light defaultLight();

}  // namespace sb
