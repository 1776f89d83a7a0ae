// Triangles that stop rays unasked (TriangleLeaf::clear): only where asking would have stopped
// them, and nearly everywhere there; shadow rays bring along the same whether they walk together,
// where that is done, or alone, where it is not.
#include <gtest/gtest.h>

#include "suites/scenes/procedural/procedural.h"
#include "suites/truth/lights/sampler.h"
#include "tests/truth/area_scenes.h"
#include "tests/truth/ray_soup.h"

namespace sb {
namespace {

using namespace test;

/// Distance from a triangle's plane.
double heightOf(const TruthTriangle& t, const dvec3& point) {
  const dvec3 n = glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
  return std::abs(glm::dot(glm::normalize(n), point - t.corners[0]));
}

/// Triangles of a list, some of which block rays that begin and end farther from their planes than
/// a height of theirs.
struct Blockers {
  std::vector<TruthTriangle> triangles;
  std::vector<double> heights;

  bool blocks(const TruthRay& ray, const TruthHit& hit) const {
    const double height = heights[hit.triangle];
    if (height == kForever) return false;
    const TruthTriangle& t = triangles[hit.triangle];
    return !(heightOf(t, ray.origin) <= height) &&
           !(ray.tMax < kForever && heightOf(t, ray.origin + ray.tMax * ray.direction) <= height);
  }
};

struct Counts {
  size_t stopped = 0, asked = 0;  ///< asked: of triangles that stop rays
};

/// Compares rays that may be stopped unasked with testing all triangles.
Counts expectStops(const Blockers& b, const std::vector<TruthRay>& rays, double reach,
                   bool unasked) {
  const Bvh bvh(b.triangles, reach, b.heights);
  Counts counts;
  for (const BoxWalks& walks : allWalks())
    for (const TruthRay& r : rays) {
      TruthRay ray = r;
      ray.stopsUnasked = unasked;
      size_t asked = 0;
      const auto judge = [&](const TruthHit& hit) {
        const bool stops = b.blocks(ray, hit);
        asked += stops;
        return stops ? Bvh::Verdict::Stop : Bvh::Verdict::Keep;
      };
      RaysTogether together(std::span(&ray, 1), judge);
      together.find(bvh, walks);
      counts.asked += asked;
      std::vector<TruthHit> expected;
      Bvh::hitsOfAll(b.triangles, ray, judge, expected);
      const bool stops = expected.size() == 1 && b.blocks(ray, expected[0]);
      counts.stopped += stops;
      EXPECT_EQ(together.stopped[0], stops);
      if (!stops) {
        EXPECT_TRUE(same(together.hits[0], expected));
      }
      if (testing::Test::HasFailure()) return counts;
    }
  return counts;
}

TEST(TruthStopping, RaysAnywhereAreStoppedByWhatBlocksThem) {
  Pcg random(31);
  Blockers b{.triangles = soup(300, 1, 30), .heights = {}};
  const double heights[] = {0, 1e-9, 0.05, kForever};
  for (size_t i = 0; i < b.triangles.size(); ++i) b.heights.push_back(heights[i % 4]);
  std::vector<TruthRay> rays;
  for (int i = 0; i < 3000; ++i) {
    TruthRay ray{.origin = randomPoint(random, 1), .direction = randomPoint(random, 1)};
    ray.tMax = i % 2 ? 1 : kForever;
    // To a corner, from a corner.
    const TruthTriangle& t = b.triangles[size_t(i) % b.triangles.size()];
    if (i % 5 == 1) ray.direction = t.corners[size_t(i) % 3] - ray.origin;
    if (i % 5 == 2) ray.origin = t.corners[size_t(i) % 3];
    if (ray.direction != dvec3(0)) rays.push_back(ray);
  }
  const Counts unasked = expectStops(b, rays, 4, true), asked = expectStops(b, rays, 4, false);
  EXPECT_EQ(unasked.stopped, asked.stopped);
  EXPECT_GT(unasked.stopped, 1000u);
  // Those that are not sure are few.
  EXPECT_LT(unasked.asked * 10, asked.asked);
}

TEST(TruthStopping, EdgesAndBothEndsAreNotSure) {
  // The last one covers nothing but what a ray must not lie in the plane of.
  Blockers b{.triangles = grid(2), .heights = {}};
  b.heights.assign(b.triangles.size(), 0x1p-40);
  std::vector<TruthRay> rays;
  Pcg random(33);
  for (int i = 0; i < 4000; ++i) {
    // From planes, edges, corners to others, and nearly: ends in a plane by less than the height,
    // or by somewhat more.
    const double off[] = {0, 0x1p-45, 0x1p-39, 0.25};
    const auto place = [&](int k) {
      return glm::round(randomPoint(random, 2.4)) +
             off[k % 4] * glm::round(randomPoint(random, 1.4));
    };
    TruthRay ray{.origin = place(i), .direction = dvec3(0), .tMax = i % 3 ? 1 : kForever};
    ray.direction = place(i / 4) - ray.origin;
    if (ray.direction != dvec3(0)) rays.push_back(ray);
  }
  EXPECT_GT(expectStops(b, rays, 8, true).stopped, 1000u);
}

TEST(TruthStopping, JustBehindAndJustBeforeAreNoHits) {
  const TruthTriangle wall{.corners = {dvec3(-9, -9, 0), dvec3(9, -9, 0), dvec3(0, 9, 0)}};
  const Blockers b{.triangles = {wall}, .heights = {0}};
  for (const double side : {-1.0, 1.0})
    for (const double z : {0.0, 1e-15, 1e-9, 1e-3})
      for (const double sign : {-1.0, 1.0}) {
        // It ends there, begins there, and goes on for ever.
        const dvec3 far(0.1, 0.2, side * 3), near(0.2, 0.1, sign * z);
        const std::vector<TruthRay> rays = {
            {.origin = far, .direction = near - far, .tMax = 1},
            {.origin = near, .direction = far - near, .tMax = 1},
            {.origin = near, .direction = far - near, .tMax = kForever},
            {.origin = far, .direction = (near - far) * 4.0, .tMax = 0.25}};
        const auto crossed = size_t(sign * z * side < 0);
        EXPECT_EQ(expectStops(b, rays, 9, true).stopped, allWalks().size() * rays.size() * crossed)
            << side << " " << sign * z;
      }
}

TEST(TruthStopping, ATriangleThatARayStartsOnDoesNotStopIt) {
  const TruthTriangle wall{.corners = {dvec3(-9, -9, 1), dvec3(9, -9, 1), dvec3(0, 9, 1)}};
  const Blockers b{.triangles = {wall}, .heights = {0}};
  const TruthRay ray{.origin = dvec3(0), .direction = dvec3(0.1, 0.1, 1), .tMax = 4};
  TruthRay own = ray;
  own.own = 0;
  EXPECT_EQ(expectStops(b, {ray}, 9, true).stopped, allWalks().size());
  const Bvh bvh(b.triangles, 9, b.heights);
  own.stopsUnasked = true;
  for (const BoxWalks& walks : allWalks()) {
    const TruthRay both[] = {own, ray};
    RaysTogether together(both, [](const TruthHit&) { return Bvh::Verdict::Keep; });
    together.find(bvh, walks);
    EXPECT_FALSE(together.stopped[0]);
    EXPECT_TRUE(together.hits[0].empty());
  }
}

TEST(TruthStopping, WhatMayBeTheReceiversOwnIsAsked) {
  Scene scene = under(sphere({0, 4, 0}, 0.5));
  addStrip(scene, 1, 0, 9);
  const RayScene rays(scene, 8, 8);
  const LightVisibility lights(rays);
  LightVisibility::Scratch scratch;
  const Tracer::Point point{.position = dvec3(0, -0.5, 0),
                            .normal = dvec3(0, 1, 0),
                            .instance = 1,  // the strip
                            .triangle = 0,
                            .translucent = false};
  const AreaSampling sampling{.first = 64, .most = 64};
  EXPECT_EQ(lights.ask(0, point, sampling, scratch, 10).visible, dvec3(1));
  EXPECT_NEAR(lights.ask(0, point, sampling, scratch).visible.x, 0.5, 0.1);
}

TEST(TruthStopping, ShadowRaysBringTheSameTogetherAsAlone) {
  constexpr uint32_t kSize = 48;
  size_t dark = 0;
  for (const char* name : {"window", "layers", "teapot", "spheres_quads:quads=80", "fog"}) {
    const Scene scene = makeScene(name);
    const RayScene rays(scene, kSize, kSize);
    const LightVisibility lights(rays);
    std::vector<Tracer::Point> points;
    for (uint32_t y = 0; y < kSize; ++y)
      for (uint32_t x = 0; x < kSize; ++x) {
        RayScene::CameraHits found;
        rays.cameraHits(x + 0.5, y + 0.5, found);
        for (const TruthHit& hit : found.hits) points.push_back(rays.point(x + 0.5, y + 0.5, hit));
      }
    LightVisibility::Scratch scratch;
    for (uint32_t light = 0; light < rays.lights(); ++light) {
      std::vector<LightVisibility::Answer> answers(points.size());
      std::vector<LightVisibility::Query> queries;
      for (size_t i = 0; i < points.size(); ++i) queries.push_back({&points[i], &answers[i]});
      lights.ask(light, queries, {}, scratch);
      for (size_t i = 0; i < points.size(); ++i) {
        ASSERT_EQ(answers[i].visible, lights.ask(light, points[i], {}, scratch).visible)
            << name << " point " << i;
        dark += answers[i].visible == dvec3(0);
      }
    }
  }
  EXPECT_GT(dark, 500u);
}

}  // namespace
}  // namespace sb
