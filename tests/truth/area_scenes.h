// A floor under one light with an extent, and shares of it that are known in closed form.
#pragma once

#include <cmath>
#include <numbers>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/truth/tracer.h"
#include "techniques/scene/light_area.h"

namespace sb::test {

/// What the truth promises: twice its standard error.
inline constexpr double kExpected = 1e-3;

inline Light areaLight(const glm::dvec3& position, LightShape shape, const glm::dvec3& halfAxes) {
  Light light = pointLight(position);
  light.shape = shape;
  light.halfAxes = glm::dmat3(glm::dvec3(halfAxes.x, 0, 0), glm::dvec3(0, 0, halfAxes.y),
                              glm::dvec3(0, halfAxes.z, 0));
  return light;
}
inline Light sphere(const glm::dvec3& position, double radius) {
  Light light = pointLight(position);
  makeSphere(light, radius);
  return light;
}

/// The floor under one light, receivers at y = 0.
inline Scene under(Light light) {
  Scene scene = floorScene(false);
  addLight(scene, std::move(light));
  return scene;
}

/// Share of the light at a place of the floor, of one channel.
inline double shareAt(const Tracer& tracer, double x, double z, const AreaSampling& sampling = {}) {
  const Tracer::Point point{.position = glm::dvec3(x, 0, z) - glm::dvec3(0, 0.5, 0),
                            .normal = glm::dvec3(0, 1, 0),
                            .instance = 0,
                            .triangle = 0,
                            .translucent = false};
  return tracer.visibility(0, point, sampling).x;
}
inline double shareAt(const Scene& scene, double x, double z) {
  return shareAt(Tracer(scene, 16, 16), x, z);
}

/// Share of a disc beyond a chord at distance d from its centre (spec 08).
inline double segment(double d) {
  if (d >= 1) return 0;
  if (d <= -1) return 1;
  return (std::acos(d) - d * std::sqrt(1 - d * d)) / std::numbers::pi;
}

/// Opaque, at height y, from x0 to x1.
inline void addStrip(Scene& scene, double y, double x0, double x1) {
  const uint32_t dark = add(scene, matte());
  addHorizontal(scene, dark, {0.5 * (x0 + x1), y, 0}, float(0.5 * (x1 - x0)), 1000);
}

}  // namespace sb::test
