// What passes a medium and what it scatters, on rays worked out by hand (spec 14: worked example,
// invariants 1, 2, 3, 4, 6; spec 17, section 14), without surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/truth/media/media.h"
#include "tests/truth/traced.h"

namespace sb::test {
namespace {

using glm::dvec3;
using Stretch = MediaField::Stretch;

constexpr double kFourPi = 4 * std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Medium box(dvec3 low, dvec3 high, glm::vec3 extinction, float albedo = 1) {
  Medium medium{.name = "box", .extinction = extinction, .albedo = glm::vec3(albedo)};
  for (int axis = 0; axis < 3; ++axis) medium.boxToWorld[axis] *= high[axis] - low[axis];
  medium.boxToWorld[3] = glm::dvec4(low, 1);
  return medium;
}

/// A scene of media alone must outlive its field.
struct Field {
  explicit Field(std::vector<Medium> media) : scene{.media = std::move(media)}, field(scene, {}) {}
  Scene scene;
  MediaField field;
};

/// Radiance 1 scattered from density 1 everywhere, or what `share` leaves of it.
MediaField::Lights uniform(std::function<double(const dvec3&)> share = [](const dvec3&) {
  return 1.0;
}) {
  return [share](const dvec3& p, std::vector<MediaField::Arrival>& out) {
    out.push_back({{0, 1, 0}, dvec3(kFourPi), dvec3(share(p))});
  };
}

const Stretch kAlongZ{{0.5, 0.5, -1}, {0, 0, 1}, 0, kInfinity};

TEST(MediaField, TheWorkedExampleHoldsForAnyNumberOfSteps) {
  const Field f({box({0, 0, 0}, {1, 1, 1.5}, {0.5f, 1, 2})});
  const dvec3 passed(0.472367, 0.223130, 0.049787);
  expectNear(f.field.transmittance(kAlongZ), passed, 1e-6);
  for (const uint32_t steps : {1u, 2u, 7u, 64u}) {
    const auto marched = f.field.march(kAlongZ, uniform(), steps);
    expectNear(marched.transmittance, passed, 1e-6);
    expectNear(marched.light, 1.0 - passed, 1e-6);
    expectNear(marched.light, f.field.march(kAlongZ, uniform(), 1).light, 1e-12);
  }
  expectNear(f.field.pass(kAlongZ, uniform()).light, 1.0 - passed, 1e-6);
}

TEST(MediaField, AGridThatRisesAlongTheRayIsExact) {
  Medium grid = box({0, 0, 0}, {1, 1, 1}, glm::vec3(4));
  grid.kind = MediumKind::Grid;
  grid.size = {1, 1, 8};
  for (int i = 0; i < 8; ++i) grid.density.push_back((float(i) + 0.5f) / 8);
  const Field f({grid});
  expectNear(f.field.transmittance(kAlongZ), dvec3(std::exp(-2.0)), 1e-12);
  // Between the middles of the outermost cells density is z itself: 4 (b^2 - a^2) / 2.
  const Stretch part{{0.25, 0.75, 0}, {0, 0, 1}, 0.125, 0.8125};
  expectNear(f.field.transmittance(part), dvec3(std::exp(-2 * (0.8125 * 0.8125 - 0.125 * 0.125))),
             1e-12);
}

TEST(MediaField, AGridIsCubicAlongARayAndExactThere) {
  Medium grid = box({0, 0, 0}, {1, 1, 1}, glm::vec3(1));
  grid.kind = MediumKind::Grid;
  grid.size = {5, 4, 3};
  for (int i = 0; i < 60; ++i) grid.density.push_back(float(i * 37 % 11) / 4);
  const Field f({grid});
  const dvec3 from(0.05, 0.9, -0.2), direction = glm::normalize(dvec3(0.6, -0.5, 0.9));
  constexpr int kSteps = 1'000'000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const dvec3 p = from + direction * (2.0 * (i + 0.5) / kSteps);
    const bool inside =
        glm::all(glm::greaterThanEqual(p, dvec3(0))) && glm::all(glm::lessThan(p, dvec3(1)));
    if (inside) sum += gridDensity(grid, p) * (2.0 / kSteps);
  }
  EXPECT_GT(sum, 0.5);
  expectNear(f.field.transmittance({from, direction, 0, kInfinity}), dvec3(std::exp(-sum)), 2e-6);
}

TEST(MediaField, SmokeIsIntegratedToItsTolerance) {
  Medium smoke = box({0, 0, 0}, {1, 1, 1}, glm::vec3(20), 0.9f);
  smoke.kind = MediumKind::Smoke;
  smoke.seed = 5;
  const Field f({smoke});
  const gpu::SmokeShape shape = smokeShape(smoke);
  for (const double y : {0.1, 0.4, 0.7}) {
    const dvec3 from(-0.5, y, 0.3), direction = glm::normalize(dvec3(1, 0.1, 0.15));
    constexpr int kSteps = 100'000;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
      sum += gpu::smokeDensity(shape, from + direction * (2.0 * (i + 0.5) / kSteps)) * 40 / kSteps;
    EXPECT_GT(sum, 0.1) << y;
    expectNear(f.field.transmittance({from, direction, 0, kInfinity}), dvec3(std::exp(-sum)), 1e-5);
  }
}

TEST(MediaField, TransmittanceFallsWithDensity) {
  double before = 1;
  for (const float k : {1e-3f, 0.1f, 1.f, 3.f, 30.f, 1e3f}) {
    Medium smoke = box({0, 0, 0}, {1, 1, 1}, glm::vec3(k));
    smoke.kind = MediumKind::Smoke;
    const Field f({smoke});
    const double t = f.field.transmittance({{-1, 0.5, 0.5}, {1, 0, 0}, 0, kInfinity}).x;
    EXPECT_LT(t, before) << k;
    EXPECT_GE(t, 0) << k;
    before = t;
  }
}

TEST(MediaField, ASplitBoxIsTheBox) {
  const glm::vec3 k(0.3f, 0.9f, 2);
  const Field whole({box({0, 0, 0}, {1, 1, 2}, k)});
  const Field split({box({0, 0, 1}, {1, 1, 2}, k), box({0, 0, 0}, {1, 1, 1}, k)});
  const auto shade = [](const dvec3& p) { return std::exp(-p.z); };
  expectNear(split.field.transmittance(kAlongZ), whole.field.transmittance(kAlongZ), 1e-14);
  expectNear(split.field.pass(kAlongZ, uniform(shade)).light,
             whole.field.pass(kAlongZ, uniform(shade)).light, 1e-5);
  // In the plane where they touch, a ray is in one of them.
  const Stretch within{{0.5, -1, 1}, {0, 1, 0}, 0, kInfinity};
  expectNear(split.field.transmittance(within), whole.field.transmittance(within), 1e-14);
  EXPECT_LT(split.field.transmittance(within).x, 0.8);
  // One interval: the point in media is the middle of both.
  const auto first = split.field.firstInterval(kAlongZ);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->from, 1);
  EXPECT_EQ(first->to, 3);
}

TEST(MediaField, DensitiesOfBoxesThatOverlapAdd) {
  const Field both({box({0, 0, 0}, {1, 1, 2}, {1, 0.5f, 0.25f}, 0.5f),
                    box({0, 0, 1}, {1, 1, 3}, {0.5f, 1, 2}, 1)});
  const dvec3 a(1, 0.5, 0.25), b(0.5, 1, 2);
  expectNear(both.field.transmittance(kAlongZ), glm::exp(-2.0 * (a + b)), 1e-14);
  // Three pieces, each of constant density and albedo.
  dvec3 light(0), through(1);
  for (const auto& [sigma, scattered] :
       {std::pair(a, 0.5 * a), std::pair(a + b, 0.5 * a + b), std::pair(b, b)}) {
    const dvec3 passes = glm::exp(-sigma);
    light += through * scattered / sigma * (1.0 - passes);
    through *= passes;
  }
  expectNear(both.field.march(kAlongZ, uniform(), 5).light, light, 1e-12);
  expectNear(both.field.pass(kAlongZ, uniform()).light, light, 1e-12);
}

TEST(MediaField, EnteringABoxIsContinuous) {
  const Field f({box({0, 0, 0}, {1, 1, 1}, glm::vec3(2))});
  auto pass = [&](double z) {
    return f.field.pass({{0.5, 0.5, z}, {0, 0, 1}, 0, kInfinity}, uniform());
  };
  const auto outside = pass(-1e-9), face = pass(0), inside = pass(1e-9), middle = pass(0.5);
  expectNear(face.light, outside.light, 1e-12);
  expectNear(inside.light, outside.light, 1e-8);
  expectNear(inside.transmittance, outside.transmittance, 1e-8);
  expectNear(middle.transmittance, dvec3(std::exp(-1.0)), 1e-14);
}

TEST(MediaField, RaysInFacesAndBesideAreFinite) {
  const Field f({box({0, 0, 0}, {1, 1, 1}, glm::vec3(2))});
  for (const dvec3 origin : {dvec3(0, 0.5, -1), dvec3(1, 0.5, -1), dvec3(0, 0, 0), dvec3(1, 1, 1),
                             dvec3(0.5, 0.5, 0), dvec3(-0.0, 0.5, -1), dvec3(2, 0.5, -1)})
    for (const dvec3 direction : {dvec3(0, 0, 1), dvec3(1, 0, 0), dvec3(-0.0, 0, 1)}) {
      const auto passage = f.field.pass({origin, direction, 0, kInfinity}, uniform());
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(passage.transmittance[c], std::exp(-2.0) - 1e-12);
        EXPECT_LE(passage.transmittance[c], 1);
        EXPECT_NEAR(passage.light[c], 1 - passage.transmittance[c], 1e-12);
      }
    }
}

TEST(MediaField, NoDensityAndMuchOfIt) {
  const Field none({box({0, 0, 0}, {1, 1, 1}, glm::vec3(0))});
  EXPECT_TRUE(none.field.empty());
  const Field mixed({box({0, 0, 0}, {1, 1, 1}, {0, 1e6f, 1}, 0.5f)});
  const auto passage = mixed.field.pass(kAlongZ, uniform());
  EXPECT_EQ(passage.transmittance.x, 1);
  EXPECT_EQ(passage.light.x, 0);
  EXPECT_EQ(passage.transmittance.y, 0);
  EXPECT_NEAR(passage.light.y, 0.5, 1e-6);
  EXPECT_NEAR(passage.light.z, 0.5 * (1 - std::exp(-1.0)), 1e-6);
  // Lit from the eye's side a dense medium shadows itself: integral of s exp(-2 s t) is 1/2.
  const auto own = [](double k) {
    return uniform([k](const dvec3& p) { return std::exp(-k * p.z); });
  };
  for (const double k : {1.0, 30.0, 1e3, 1e6}) {
    const Field f({box({0, 0, 0}, {1, 1, 1}, glm::vec3(float(k)))});
    EXPECT_NEAR(f.field.pass(kAlongZ, own(k)).light.x, 0.5 * (1 - std::exp(-2 * k)), 5e-4) << k;
  }
}

TEST(MediaField, TheMarchConvergesBySquares) {
  // A light beside the ray: its irradiance is smooth.
  const Field f({box({0, 0, 0}, {1, 1, 1}, glm::vec3(1.5f))});
  const auto near = uniform([](const dvec3& p) { return 1 / (0.1 + (p.z - 0.4) * (p.z - 0.4)); });
  std::vector<double> light;
  for (uint32_t n = 8; n <= 256; n *= 2) light.push_back(f.field.march(kAlongZ, near, n).light.x);
  for (size_t i = 2; i < light.size(); ++i) {
    const double ratio = (light[i - 2] - light[i - 1]) / (light[i - 1] - light[i]);
    EXPECT_NEAR(ratio, 4, 1) << i;
  }
  // Richardson's extrapolation of the last two is right to far more digits.
  const double limit = (4 * light.back() - light[light.size() - 2]) / 3;
  EXPECT_NEAR(f.field.pass(kAlongZ, near).light.x, limit, 1e-3 * limit);
}

TEST(MediaField, ShadowsInAMediumAreFound) {
  // Lit from z = 0.4371 on alone; and in the slot from 0.30 to 0.37 alone.
  const Field f({box({0, 0, 0}, {1, 1, 1}, glm::vec3(1))});
  const auto lit = uniform([](const dvec3& p) { return p.z > 0.4371 ? 1.0 : 0.0; });
  EXPECT_NEAR(f.field.pass(kAlongZ, lit).light.x, std::exp(-0.4371) - std::exp(-1.0), 1e-3 * 0.632);
  const auto slot = uniform([](const dvec3& p) { return p.z > 0.3 && p.z < 0.37 ? 1.0 : 0.0; });
  EXPECT_NEAR(f.field.pass(kAlongZ, slot).light.x, std::exp(-0.3) - std::exp(-0.37), 1e-3 * 0.632);
}

TEST(MediaField, FarFromTheOriginAndTurnedBoxesAreTheSame) {
  Medium turned = box({0, 0, 0}, {1, 1, 1}, glm::vec3(1));
  const double s = std::sqrt(0.5);
  turned.boxToWorld = glm::dmat4(s, s, 0, 0, -s, s, 0, 0, 0, 0, 1, 0, 1e7, -1e7, 0.5, 1);
  const Scene scene{.media = {turned}};
  const MediaField field(scene, {1e7, -1e7, 0});
  // Through the diagonal of its square face.
  const Stretch diagonal{{0, -1, 1}, {0, 1, 0}, 0, kInfinity};
  expectNear(field.transmittance(diagonal), dvec3(std::exp(-std::sqrt(2.0))), 1e-8);
}

}  // namespace
}  // namespace sb::test
