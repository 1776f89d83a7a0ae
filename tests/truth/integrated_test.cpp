// Direct light integrated over a light (spec 16, E-mode) against form factors, and where it must be
// what lighting from the centre gives.
#include <gtest/gtest.h>

#include <numbers>

#include "base/worst.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/truth/lights/light_visibility.h"
#include "tests/truth/traced.h"

namespace sb::test {
namespace {

using glm::dvec3;

Scene floorUnder(const Light& light) {
  Scene scene = floorScene(false);
  addLight(scene, light);
  return scene;
}

/// Irradiance of a point of the floor: reflection by a surface of f_r = 1.
double irradiance(const Scene& scene, double x, double z, const AreaSampling& sampling = {}) {
  const RayScene rays(scene, 16, 16);
  const LightVisibility lights(rays);
  const Tracer::Point point{.position = dvec3(x, -0.5, z),
                            .normal = dvec3(0, 1, 0),
                            .instance = 0,
                            .triangle = 0,
                            .translucent = false};
  LightVisibility::Scratch scratch;
  return lights
      .integrate(
          0, point, [](const dvec3& toLight) { return dvec3(std::max(0.0, toLight.y)); }, sampling,
          scratch)
      .visible.x;
}

/// Of a point below one corner of a parallel rectangle a x b at height h (Howell's C-4 / pi L).
double cornerFactor(double a, double b, double h) {
  const double x = a / h, y = b / h, sx = std::sqrt(1 + x * x), sy = std::sqrt(1 + y * y);
  return (x / sx * std::atan(y / sx) + y / sy * std::atan(x / sy)) / (2 * std::numbers::pi);
}

Light rectangle(double a, double b, double height) {
  Light light = pointLight({0, height, 0}, 4 * float(a * b));  // radiance 1
  light.shape = LightShape::Rectangle;
  light.halfAxes = glm::dmat3(dvec3(a, 0, 0), dvec3(0, 0, b), dvec3(0));
  return light;
}

TEST(TruthIntegrated, ARectangleGivesItsFormFactor) {
  const Scene scene = floorUnder(rectangle(1, 0.5, 2));
  const double straight = std::numbers::pi * 4 * cornerFactor(1, 0.5, 2);
  EXPECT_NEAR(irradiance(scene, 0, 0), straight, 1e-3 * straight);
  // Below a corner, and beyond one: four rectangles, two of them taken away.
  const double corner = std::numbers::pi * cornerFactor(2, 1, 2);
  EXPECT_NEAR(irradiance(scene, 1, 0.5), corner, 2e-3 * corner);
  const double outside = std::numbers::pi * 2 * (cornerFactor(3, 0.5, 2) - cornerFactor(1, 0.5, 2));
  EXPECT_NEAR(irradiance(scene, 2, 0), outside, 2e-3 * outside);
}

TEST(TruthIntegrated, ShadowsTakeTheirPart) {
  Scene scene = floorUnder(rectangle(1, 0.5, 2));
  // Hides x > 0 from the middle.
  addHorizontal(scene, add(scene, matte()), {500, 1, 0}, 500, 1000);
  const double half = std::numbers::pi * 2 * cornerFactor(1, 0.5, 2);
  EXPECT_NEAR(irradiance(scene, 0, 0), half, 2e-3 * half);
  addHorizontal(scene, add(scene, glass(0.5f, glm::vec3(0))), {0, 0.75f, 0}, 1000, 1000);
  EXPECT_NEAR(irradiance(scene, 0, 0), half / 2, 2e-3 * half);
}

TEST(TruthIntegrated, ASphereLightsAsItsCentreDoes) {
  // pi L sin^2 = I / d^2 of a facing surface; a sun gives its illuminance.
  Light lamp = pointLight({0, 3, 0}, 9);
  makeSphere(lamp, 1.5);
  EXPECT_NEAR(irradiance(floorUnder(lamp), 0, 0), 1, 1e-3);
  const double d2 = 9 + 4, cosine = 3 / std::sqrt(d2);
  EXPECT_NEAR(irradiance(floorUnder(lamp), 2, 0), 9 / d2 * cosine, 2e-3);
  Light day = sun({0, -1, 0});
  day.angularRadius = 0.4;
  EXPECT_NEAR(irradiance(floorUnder(day), 0, 0), std::numbers::pi, 1e-3 * std::numbers::pi);
  lamp.halfAxes = glm::dmat3(1.5);
  lamp.halfAxes[0] *= 1 + 1e-9;  // an ellipsoid that is nearly a sphere
  EXPECT_NEAR(irradiance(floorUnder(lamp), 0, 0), 1, 1e-3);
}

TEST(TruthIntegrated, PicturesOfSmallLightsAreThoseOfTheirCentres) {
  Light lamp = pointLight({0.5, 3, 0.2});
  const auto worst = [&](double radius) {
    makeSphere(lamp, radius);
    Scene scene = floorUnder(lamp);
    addHorizontal(scene, add(scene, matte()), {1, 1, 0}, 0.5f, 0.5f);
    const Tracer tracer(scene, 24, 24);
    const Truth centre = *tracer.trace({.width = 24, .height = 24});
    const Truth all = *tracer.trace({.width = 24, .height = 24, .sampling = {.integrated = true}});
    EXPECT_EQ(all.visibility, centre.visibility);
    float worst = 0;
    for (size_t k = 0; k < all.image.size(); ++k)
      worst = base::worse(worst, std::abs(all.image[k] - centre.image[k]));
    return worst;
  };
  EXPECT_LT(worst(0.01), 5e-4f);
  EXPECT_GT(worst(1), 2e-3f) << "a large one is not its centre";
}

}  // namespace
}  // namespace sb::test
