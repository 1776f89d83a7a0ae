#include "techniques/scene/camera.h"

#include <cmath>

namespace sb {

glm::dmat4 perspective(double fovY, double aspect, double n, double f) {
  const double t = std::tan(fovY / 2);
  glm::dmat4 m(0);
  m[0][0] = 1 / (aspect * t);
  m[1][1] = 1 / t;
  m[2][2] = n / (f - n);
  m[2][3] = -1;
  m[3][2] = n * f / (f - n);
  return m;
}

glm::dmat4 orthographic(double l, double r, double b, double t, double n, double f) {
  glm::dmat4 m(1);
  m[0][0] = 2 / (r - l);
  m[1][1] = 2 / (t - b);
  m[2][2] = 1 / (f - n);
  m[3] = glm::dvec4(-(r + l) / (r - l), -(t + b) / (t - b), f / (f - n), 1);
  return m;
}

CameraMatrices cameraMatrices(const Camera& camera, double aspect) {
  CameraMatrices m;
  m.eye = camera.eye();
  m.view = glm::dmat4(glm::transpose(glm::dmat3(camera.toWorld)));
  const double h = camera.halfHeight;
  m.projection =
      camera.orthographic
          ? orthographic(-h * aspect, h * aspect, -h, h, camera.nearPlane, camera.farPlane)
          : perspective(camera.fovY, aspect, camera.nearPlane, camera.farPlane);
  m.viewProjection = m.projection * m.view;
  return m;
}

CameraRays cameraRays(const Camera& camera, uint32_t width, uint32_t height) {
  const glm::dmat3 axes(camera.toWorld);
  const double n = camera.nearPlane, f = camera.farPlane;
  const double half = camera.orthographic ? camera.halfHeight : std::tan(camera.fovY / 2);
  const double pixel = 2 * half / height;
  CameraRays rays;
  rays.forward = -axes[2];
  rays.parallel = camera.orthographic;
  rays.right = axes[0] * pixel;
  rays.up = axes[1] * pixel;
  rays.origin = -rays.right * (0.5 * width) - rays.up * (0.5 * height);
  if (!camera.orthographic) rays.origin += rays.forward;
  // Depth is n f / (f - n) / z - n / (f - n); orthographic (f - z) / (f - n).
  rays.depthToDistance = camera.orthographic ? glm::dvec4(f, n - f, 1, 0)
                                             : glm::dvec4(n * f / (f - n), 0, n / (f - n), 1);
  return rays;
}

std::array<glm::dvec3, 8> frustumCorners(const Camera& camera, double aspect, double farLimit) {
  const glm::dmat3 axes(camera.toWorld);
  const double far = std::max(camera.nearPlane, std::min(camera.farPlane, farLimit));
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i) {
    const double depth = i & 4 ? far : camera.nearPlane;
    const double h = camera.orthographic ? camera.halfHeight : depth * std::tan(camera.fovY / 2);
    corners[size_t(i)] = axes * glm::dvec3((i & 1 ? h : -h) * aspect, i & 2 ? h : -h, -depth);
  }
  return corners;
}

}  // namespace sb
