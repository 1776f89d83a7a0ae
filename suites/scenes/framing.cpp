#include "suites/scenes/framing.h"

#include <cmath>

namespace sb {

glm::dmat4 lookFrom(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up) {
  const glm::dvec3 z = glm::normalize(eye - target);
  if (std::abs(glm::dot(z, glm::normalize(up))) > 0.9999) up = {0, 0, -1};
  const glm::dvec3 x = glm::normalize(glm::cross(up, z));
  const glm::dvec3 y = glm::cross(z, x);
  return glm::dmat4(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(eye, 1));
}

Camera framingCamera(const Bounds& box) {
  const glm::dvec3 center = box.empty() ? glm::dvec3(0) : box.center();
  const double radius = box.empty() || box.radius() == 0 ? 1.0 : box.radius();
  Camera camera;
  camera.name = "framing";
  camera.fovY = 0.8;
  const double distance = 1.05 * radius / std::sin(0.5 * camera.fovY);
  camera.toWorld = lookFrom(center + distance * glm::normalize(glm::dvec3(0.5, 0.45, 1.0)), center);
  camera.nearPlane = 0.9 * (distance - radius);
  camera.farPlane = 1.1 * (distance + radius);
  return camera;
}

Light defaultLight() {
  Light light;
  light.name = "default";
  light.direction = glm::normalize(glm::dvec3(0.45, -1.0, -0.5));
  light.intensity = 3.14159265f;
  return light;
}

}  // namespace sb
