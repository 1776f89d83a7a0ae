// Camera matrices in double, camera-relative: the eye is the origin of everything that is uploaded,
// so that nothing depends on where in the world the scene lies (spec 17, G1). Depth is reversed, 1
// near to 0 far: a perspective depth of n / z keeps its relative precision at every distance (N3).
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "techniques/scene/placed_scene.h"

namespace sb {

struct CameraMatrices {
  glm::dvec3 eye = glm::dvec3(0);
  glm::dmat4 view = glm::dmat4(1);            ///< camera-relative world -> view (a rotation)
  glm::dmat4 projection = glm::dmat4(1);      ///< view -> clip, depth 1 near .. 0 far
  glm::dmat4 viewProjection = glm::dmat4(1);  ///< camera-relative world -> clip
};

/// Camera-relative rays through a window and distances along the camera's axis from depths.
struct CameraRays {
  glm::dvec3 origin;   ///< of window (0, 0): a point one unit before the eye; orthographic: its start
  glm::dvec3 right;    ///< change of it by one pixel
  glm::dvec3 up;       ///< by one row, upwards
  glm::dvec3 forward;  ///< unit
  bool parallel;       ///< orthographic
  glm::dvec4 depthToDistance;  ///< (x + y depth) / (z + w depth)
};
CameraRays cameraRays(const Camera& camera, uint32_t width, uint32_t height);

/// `aspect`: width / height of the picture.
CameraMatrices cameraMatrices(const Camera& camera, double aspect);

/// The eight corners of the part of the frustum between near and min(far, `farLimit`),
/// camera-relative. Order: x fastest, then y, then near before far.
std::array<glm::dvec3, 8> frustumCorners(const Camera& camera, double aspect, double farLimit);

/// Projections to depth 1 near .. 0 far, looking down -z.
glm::dmat4 perspective(double fovY, double aspect, double nearPlane, double farPlane);
glm::dmat4 orthographic(double left, double right, double bottom, double top, double nearPlane,
                        double farPlane);

}  // namespace sb
