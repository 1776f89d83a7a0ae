// Lights with an extent in the truth: visibility against answers that are worked out by hand or by
// clipping polygons exactly (spec 16, area integration and validation 1, 2, 5; spec 08's closed
// forms), where it is exact with one ray, and what its sampling may depend on.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/random.h"
#include "suites/scenes/procedural/shapes.h"
#include "suites/truth/tracer.h"
#include "suites/truth/truth_cache.h"
#include "techniques/scene/light_area.h"

namespace sb::test {
namespace {

using glm::dvec2;
using glm::dvec3;

/// What the truth promises: twice its standard error.
constexpr double kExpected = 1e-3;

Light areaLight(const dvec3& position, LightShape shape, const dvec3& halfAxes) {
  Light light = pointLight(position);
  light.shape = shape;
  light.halfAxes =
      glm::dmat3(dvec3(halfAxes.x, 0, 0), dvec3(0, 0, halfAxes.y), dvec3(0, halfAxes.z, 0));
  return light;
}
Light sphere(const dvec3& position, double radius) {
  Light light = pointLight(position);
  makeSphere(light, radius);
  return light;
}

/// The floor under one light, receivers at y = 0.
Scene under(Light light) {
  Scene scene = floorScene(false);
  addLight(scene, std::move(light));
  return scene;
}

/// Share of the light at a place of the floor, of one channel.
double shareAt(const Tracer& tracer, double x, double z, const AreaSampling& sampling = {}) {
  const Tracer::Point point{.position = dvec3(x, 0, z) - dvec3(0, 0.5, 0),
                            .normal = dvec3(0, 1, 0),
                            .instance = 0,
                            .triangle = 0,
                            .translucent = false};
  return tracer.visibility(0, point, sampling).x;
}
double shareAt(const Scene& scene, double x, double z) {
  return shareAt(Tracer(scene, 16, 16), x, z);
}

/// Share of a disc beyond a chord at distance d from its centre (spec 08).
double segment(double d) {
  if (d >= 1) return 0;
  if (d <= -1) return 1;
  return (std::acos(d) - d * std::sqrt(1 - d * d)) / std::numbers::pi;
}

/// Opaque, at height y, from x0 to x1.
void addStrip(Scene& scene, double y, double x0, double x1) {
  const uint32_t dark = add(scene, matte());
  addHorizontal(scene, dark, {0.5 * (x0 + x1), y, 0}, float(0.5 * (x1 - x0)), 1000);
}

TEST(TruthArea, AHalfPlaneUnderADiscLeavesTheSegment) {
  // Spec 16's worked example: the edge x = .25 at height 2 is .5 on the disc of radius 1 at
  // height 4.
  for (const double edge : {-0.45, -0.1, 0.0, 0.25, 0.4}) {
    Scene scene = under(areaLight({0, 4, 0}, LightShape::Disc, {1, 1, 0}));
    addStrip(scene, 2, edge, 1000);
    EXPECT_NEAR(shareAt(scene, 0, 0), 1 - segment(2 * edge), kExpected) << edge;
  }
  Scene scene = under(areaLight({0, 4, 0}, LightShape::Disc, {1, 1, 0}));
  addStrip(scene, 2, 0.25, 1000);
  EXPECT_NEAR(shareAt(scene, 0, 0), 0.804499, kExpected);
}

TEST(TruthArea, ASphereIsTheDiscOfItsTangentCone) {
  // Seen from x = 0, z = 0 straight below: radius R D / sqrt(D^2 - R^2).
  const double r = 1, d = 2, radius = r * d / std::sqrt(d * d - r * r);
  for (const double edge : {-0.3, 0.1, 0.4}) {
    Scene scene = under(sphere({0, d, 0}, r));
    addStrip(scene, 0.5, edge, 1000);
    EXPECT_NEAR(shareAt(scene, 0, 0), 1 - segment(edge * d / 0.5 / radius), kExpected) << edge;
  }
}

TEST(TruthArea, AnEllipsoidIsTheImageOfASphere) {
  // Stretching scene and light alike changes nothing.
  Scene round = under(sphere({0.3, 3, 0.2}, 0.8));
  addStrip(round, 1, 0.1, 1000);
  Scene stretched = under(areaLight({0.6, 3, 0.2}, LightShape::Ellipsoid, {1.6, 0.8, 0.8}));
  addStrip(stretched, 1, 0.2, 2000);
  for (const double x : {-0.4, -0.1, 0.0, 0.3})
    EXPECT_NEAR(shareAt(round, x, 0), shareAt(stretched, 2 * x, 0), kExpected) << x;
}

TEST(TruthArea, AStripUnderARectangleLeavesTheRest) {
  // The strip [-.1, .3] at height 1 is [-.4, 1.2] at height 4; the rectangle [-1, 1].
  Scene scene = under(areaLight({0, 4, 0}, LightShape::Rectangle, {1, 0.5, 0}));
  addStrip(scene, 1, -0.1, 0.3);
  EXPECT_NEAR(shareAt(scene, 0, 0), 0.3, kExpected);
  // From x = .4 the strip is at .4 + 4 ([-.5, -.1]) = [-1.6, 0].
  EXPECT_NEAR(shareAt(scene, 0.4, 0), 0.5, kExpected);
  EXPECT_EQ(shareAt(scene, 1.5, 0), 1);
}

TEST(TruthArea, ASunIsADiscOfItsAngle) {
  Scene scene = under(sun({0, -1, 0}));
  scene.lights[0].angularRadius = 0.1;
  addStrip(scene, 2, 0.05, 1000);
  EXPECT_NEAR(shareAt(scene, 0, 0), 1 - segment(0.025 / std::tan(0.1)), kExpected);
}

TEST(TruthArea, OverlappingQuadsDoNotCountTwice) {
  Scene scene = under(areaLight({0, 4, 0}, LightShape::Rectangle, {1, 1, 0}));
  addStrip(scene, 2, -0.25, 1000);   // x > -.5 of the light
  addStrip(scene, 1, -0.0625, 0.5);  // x > -.25
  EXPECT_NEAR(shareAt(scene, 0, 0), 0.25, kExpected);
  // Translucent ones multiply where they overlap.
  Scene panes = under(areaLight({0, 4, 0}, LightShape::Rectangle, {1, 1, 0}));
  addHorizontal(panes, add(panes, glass(0.5f, glm::vec3(0))), {500, 2, 0}, 500, 1000);
  addHorizontal(panes, add(panes, glass(0.25f, glm::vec3(0))), {500.125f, 1, 0}, 500, 1000);
  // x < 0: 1; to .5: .5; beyond: .375.
  EXPECT_NEAR(shareAt(panes, 0, 0), 0.5 * 1 + 0.25 * 0.5 + 0.25 * 0.375, kExpected);
}

/// Area of a convex polygon in the unit disc, by adding up what each edge and the centre enclose.
double areaInDisc(const std::vector<dvec2>& corners) {
  const auto wedge = [](dvec2 a, dvec2 b) {  // triangle (0, a, b) cut by the circle
    const auto cross = [](dvec2 p, dvec2 q) { return p.x * q.y - p.y * q.x; };
    const auto sector = [&](dvec2 p, dvec2 q) {
      return 0.5 * std::atan2(cross(p, q), glm::dot(p, q));
    };
    const dvec2 d = b - a;
    const double A = glm::dot(d, d), B = glm::dot(a, d), C = glm::dot(a, a) - 1;
    const double root = B * B - A * C;
    if (root <= 0) return sector(a, b);
    const double t0 = (-B - std::sqrt(root)) / A, t1 = (-B + std::sqrt(root)) / A;
    if (t1 <= 0 || t0 >= 1) return sector(a, b);
    const dvec2 p = a + std::max(t0, 0.0) * d, q = a + std::min(t1, 1.0) * d;
    return (t0 > 0 ? sector(a, p) : 0) + 0.5 * cross(p, q) + (t1 < 1 ? sector(q, b) : 0);
  };
  double area = 0;
  for (size_t i = 0; i < corners.size(); ++i)
    area += wedge(corners[i], corners[(i + 1) % corners.size()]);
  return area;
}

TEST(TruthArea, AConvexPolygonIsClippedExactly) {
  EXPECT_NEAR(areaInDisc({{-0.3, -0.4}, {0.9, -0.2}, {0.1, 1.2}}) / std::numbers::pi, 0.287040,
              1e-6)
      << "spec 08";
  Pcg random(5);
  const auto u = [&] { return 2 * random.uniform() - 1; };
  size_t partly = 0;
  double squares = 0;
  for (int n = 0; n < 24; ++n) {
    // A tilted triangle between the floor's middle and a disc of radius 1 at height 4.
    Scene scene = under(areaLight({0, 4, 0}, LightShape::Disc, {1, 1, 0}));
    Mesh mesh = quadMesh(add(scene, matte()), {0, 0, 0}, {1, 0, 0}, {0, 0, 1});
    mesh.positions.resize(3), mesh.normals.resize(3), mesh.uv0.clear();
    mesh.indices = {0, 1, 2};
    mesh.triangleKeys = {0};
    std::vector<dvec2> projected;
    for (glm::vec3& p : mesh.positions) {
      p = glm::vec3(glm::dvec3(0.6 * u(), 2 + 0.8 * u(), 0.6 * u()));
      projected.push_back(dvec2(p.x, p.z) * (4 / double(p.y)));
    }
    place(scene, add(scene, mesh));
    const double expected = 1 - std::abs(areaInDisc(projected)) / std::numbers::pi;
    partly += expected > 0.02 && expected < 0.98;
    const Tracer tracer(scene, 16, 16);
    const double found = shareAt(tracer, 0, 0);
    squares += (found - expected) * (found - expected);
    EXPECT_NEAR(found, expected, 2 * kExpected) << n;
    EXPECT_NEAR(shareAt(tracer, 0, 0, {.error = 1e-4}), expected, kExpected) << n;
  }
  EXPECT_LT(std::sqrt(squares / 24), 5e-4);
  EXPECT_GT(partly, 12u);
}

TEST(TruthArea, NothingBetweenIsExactForEveryShape) {
  for (Light light : {sphere({1, 3, 0}, 1), areaLight({0, 3, 0}, LightShape::Disc, {1, 1, 0}),
                      areaLight({0, 3, 0}, LightShape::Rectangle, {2, 1, 0})}) {
    Scene scene = under(light);
    const auto t = *Tracer(scene, 16, 16).trace({.width = 16, .height = 16});
    EXPECT_EQ(t.standardError, 0);
    EXPECT_EQ(t.rays, 16u * 16 * 5 * 2) << "one to the eye and one to the light";
    for (size_t p = 0; p < 256; ++p) ASSERT_EQ(t.visibility[0][4 * p], 1.0f);
  }
}

TEST(TruthArea, WhatHidesAllOfTheLightIsExact) {
  Scene scene = under(areaLight({0, 4, 0}, LightShape::Disc, {0.5, 0.5, 0}));
  // Two triangles; receivers near x + z = 0 see their common edge.
  addHorizontal(scene, add(scene, glass(0.5f, {0, 0.5f, 1})), {0, 2, 0}, 1000, 1000);
  const Tracer tracer(scene, 16, 16);
  Tracer::Point point{.position = dvec3(2, 0, 1) - dvec3(0, 0.5, 0),
                      .normal = dvec3(0, 1, 0),
                      .instance = 0,
                      .triangle = 0,
                      .translucent = false};
  EXPECT_EQ(tracer.visibility(0, point), dvec3(0.5, 0.75, 1));
  const Truth t = *tracer.trace({.width = 16, .height = 16});
  EXPECT_EQ(t.visibility[0][4 * (16 * 3 + 2)], 0.5f);
  addHorizontal(scene, add(scene, matte()), {0, 3, 0}, 1000, 1000);
  EXPECT_EQ(shareAt(scene, 2, 1), 0);
}

TEST(TruthArea, WithinTheLightNothingIsDefined) {
  Scene scene = under(sphere({0, 0.1, 0}, 1));
  addStrip(scene, 0.05, 0, 1000);
  const Truth t = *Tracer(scene, 16, 16).trace({.width = 16, .height = 16});
  const size_t middle = 8 * 16 + 7, corner = 0;
  EXPECT_EQ(t.visibility[0][4 * middle + 3], 0) << "excluded";
  EXPECT_EQ(t.visibility[0][4 * corner + 3], 1);
  EXPECT_EQ(t.imageEdges[middle], 1);
}

TEST(TruthArea, ALampInTheCeilingIsNotShadowedByIt) {
  Scene scene = under(areaLight({0.3, 4, 0.1}, LightShape::Rectangle, {0.7, 0.3, 0}));
  addStrip(scene, 4, -1000, 1000);
  const Tracer tracer(scene, 16, 16);
  for (int i = 0; i < 32; ++i) {
    EXPECT_EQ(shareAt(tracer, 0.123 * i, 0.456), 1) << i;
    EXPECT_EQ(shareAt(tracer, 0.123 * i, 0.456, {.pattern = 16}), 1) << i;
  }
}

TEST(TruthArea, WhatFewSamplesMissIsFound) {
  // A few thousandths of the disc: 256 samples may all pass them by, and agree.
  for (const double edge : {0.96, 0.965, 0.97, 0.975}) {
    Scene scene = under(areaLight({0, 4, 0}, LightShape::Disc, {1, 1, 0}));
    addStrip(scene, 2, edge / 2, 1000);
    EXPECT_NEAR(shareAt(scene, 0, 0), 1 - segment(edge), 1.5e-3) << edge;
  }
}

Scene penumbra() {
  Scene scene = under(sphere({0.5, 4, 0.2}, 0.7));
  addHorizontal(scene, add(scene, matte()), {0, 2, 0}, 0.6f, 0.8f);
  addHorizontal(scene, add(scene, glass(0.6f, {0.9f, 0.3f, 0.1f})), {0.4f, 1, 0.5f}, 0.9f, 0.5f);
  return scene;
}

TEST(TruthArea, TheErrorIsBelowWhatIsAsked) {
  const Truth t = *Tracer(penumbra(), 24, 24).trace({.width = 24, .height = 24});
  EXPECT_GT(t.standardError, 0);
  EXPECT_LT(t.standardError, 5e-4);
  const Truth fine =
      *Tracer(penumbra(), 24, 24).trace({.width = 24, .height = 24, .sampling = {.error = 5e-5}});
  EXPECT_LT(fine.standardError, t.standardError);
  EXPECT_GT(fine.rays, 2 * t.rays);
  // The estimate is to be believed.
  double squares = 0;
  size_t sampled = 0;
  for (size_t k = 0; k < t.visibility[0].size(); ++k) {
    const double off = double(t.visibility[0][k]) - double(fine.visibility[0][k]);
    ASSERT_LT(std::abs(off), 6 * 5e-4) << k;
    squares += off * off;
    sampled += off != 0;
  }
  EXPECT_GT(sampled, 300u);
  EXPECT_LT(std::sqrt(squares / double(sampled)), 5e-4);
}

TEST(TruthArea, DependsOnNeitherThreadsNorPlace) {
  Scene scene = penumbra();
  const auto trace = [&](unsigned threads) {
    return *Tracer(scene, 24, 24, threads).trace({.width = 24, .height = 24});
  };
  const Truth one = trace(1), two = trace(2);
  EXPECT_EQ(one.visibility, two.visibility);
  EXPECT_EQ(one.image, two.image);
  EXPECT_EQ(one.rays, two.rays);
  EXPECT_EQ(one.standardError, two.standardError);
  translateScene(scene, {1e7, -1e7, 1e7});
  const Truth there = trace(0);
  for (size_t k = 0; k < one.visibility[0].size(); ++k)
    ASSERT_NEAR(one.visibility[0][k], there.visibility[0][k], 1e-6f) << k;
}

TEST(TruthArea, PenumbraeAreNoEdgesAndContactsAre) {
  const auto edges = [](double radius, double height) {
    Scene scene = under(sphere({0, 6, 0}, radius));
    addStrip(scene, height, 0.03, 1000);
    const Truth t = *Tracer(scene, 64, 64).trace({.width = 64, .height = 64});
    size_t count = 0;
    for (size_t x = 16; x < 48; ++x) count += t.edges[0][32 * 64 + x];
    return count;
  };
  EXPECT_EQ(edges(1, 2), 0u) << "a penumbra of a dozen pixels";
  EXPECT_GE(edges(0, 2), 4u) << "hard";
  EXPECT_GE(edges(0.001, 2), 4u) << "a penumbra of a hundredth of a pixel";
}

TEST(TruthArea, APatternTakesAsManyRaysAndConverges) {
  const Scene scene = penumbra();
  const Tracer tracer(scene, 32, 32);
  const Truth exact = *tracer.trace({.width = 32, .height = 32});
  double last = HUGE_VAL;
  for (const uint32_t rays : {1u, 16u, 256u}) {
    const Truth t = *tracer.trace({.width = 32, .height = 32, .sampling = {.pattern = rays}});
    double sum = 0;
    for (size_t k = 0; k < t.visibility[0].size(); ++k) {
      const double off = double(t.visibility[0][k]) - double(exact.visibility[0][k]);
      sum += off * off;
    }
    EXPECT_LT(sum, 0.25 * last) << rays;
    last = sum;
    uint64_t count = 0;
    const auto image = tracer.image(rays, &count);
    EXPECT_EQ(image, t.image);
    EXPECT_GE(count, uint64_t(rays) * 900);
  }
  // One ray goes to the centre: hard shadows.
  Scene hard = scene;
  hard.lights[0].shape = LightShape::Point;
  EXPECT_EQ(tracer.image(1), Tracer(hard, 32, 32).image(1));
}

TEST(TruthArea, SamplingIsPartOfTheKey) {
  const std::string key = truthKey("s", 8, 8);
  for (const AreaSampling& other :
       {AreaSampling{.first = 512}, AreaSampling{.most = 1024}, AreaSampling{.error = 1e-3},
        AreaSampling{.pattern = 16}, AreaSampling{.integrated = true}})
    EXPECT_NE(truthKey("s", 8, 8, other), key);
}

}  // namespace
}  // namespace sb::test
