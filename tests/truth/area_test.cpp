// Lights with an extent in the truth: visibility against answers that are worked out by hand or by
// clipping polygons exactly (spec 16, area integration and validation 1, 2; spec 08's closed forms).
#include <gtest/gtest.h>

#include "suites/scenes/procedural/parts/random.h"
#include "tests/truth/area_scenes.h"

namespace sb::test {
namespace {

using glm::dvec2;

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

}  // namespace
}  // namespace sb::test
