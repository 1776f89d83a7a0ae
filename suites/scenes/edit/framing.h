// A camera, light and ground for scenes that bring none.
#pragma once

#include "techniques/scene/scene.h"

namespace sb {

/// Camera frame at `eye` that looks at `target`, y up as far as possible.
glm::dmat4 lookFrom(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up = glm::dvec3(0, 1, 0));
/// A perspective camera, in front, above and to the right of the scene, that sees all of it in
/// pictures at least as wide as high: of a square picture its vertices fill 80 % of the width or of
/// the height, whichever is more. Near and far planes enclose it.
Camera framingCamera(const Scene& scene);
/// What a scene's warnings say when one of the two was added; void once an edit sets its own.
inline constexpr const char* kCameraAdded =
    "the file shows no camera; one that frames the whole scene was added";
inline constexpr const char* kLightAdded = "the file shows no light; a sun and a sky were added";
/// Radiance where nothing is, of files that state none: a grey that dark and bright models stand
/// out against.
inline constexpr glm::vec3 kNeutralBackground = glm::vec3(0.25f);
/// White, from above the viewer's left shoulder; a white diffuse surface that faces it gets
/// radiance 1 (illuminance pi).
Light defaultLight();
/// A sun as above and a sky (Scene::sky), for files without light: together with the ambient light
/// a white surface gets radiance 1 at most, one in the shade 0.1 to 0.3.
void addDaylight(Scene& scene);
/// A grey, rough plane just below the lowest point of the scene, `size` times as wide as the scene,
/// for models that bring nothing to receive their shadow. Cameras' far planes move behind it.
void addGround(Scene& scene, double size);

}  // namespace sb
