// Walks through the tree of boxes: alone and in packets, with every set of instructions, rays meet
// exactly what testing every triangle finds; so pictures depend neither on the CPU nor on who walks
// beside whom.
#include <gtest/gtest.h>

#include "suites/scenes/procedural/procedural.h"
#include "suites/truth/lights/sampler.h"
#include "tests/truth/ray_soup.h"

namespace sb {
namespace {

using namespace test;

/// Compares every way to find the hits of `rays`; returns how many there are.
size_t expectSame(const std::vector<TruthTriangle>& triangles, const std::vector<TruthRay>& rays,
                  double reach, const Bvh::Judge& judge) {
  const Bvh bvh(triangles, reach);
  size_t found = 0;
  std::vector<TruthHit> expected, alone;
  for (const BoxWalks& walks : allWalks())
    for (size_t first = 0, count = 1; first < rays.size(); first += count, count = count % 20 + 1) {
      const auto some = std::span(rays).subspan(first, std::min(count, rays.size() - first));
      RaysTogether together(some, judge);
      together.find(bvh, walks);
      for (size_t i = 0; i < some.size(); ++i) {
        Bvh::hitsOfAll(triangles, some[i], judge, expected);
        bvh.hits(some[i], judge, alone, walks);
        // Which hit stops a search is not defined.
        const bool stops = expected.size() == 1 && judge(expected[0]) == Bvh::Verdict::Stop;
        EXPECT_TRUE(stops ? alone.size() == 1 && judge(alone[0]) == Bvh::Verdict::Stop
                          : same(alone, expected))
            << "ray " << first + i << " alone: " << alone.size() << " of " << expected.size();
        EXPECT_EQ(together.stopped[i], stops) << "ray " << first + i;
        EXPECT_TRUE(stops || same(together.hits[i], expected))
            << "ray " << first + i << " of " << some.size() << ": " << together.hits[i].size()
            << " of " << expected.size();
        found += expected.size();
        if (testing::Test::HasFailure()) return found;
      }
    }
  return found;
}

Bvh::Verdict keepAll(const TruthHit&) { return Bvh::Verdict::Keep; }

/// Directions with components that are zero, of either sign, or nearly.
dvec3 degenerate(Pcg& random, int kind) {
  dvec3 d = randomPoint(random, 1);
  const double small[] = {0.0, -0.0, 1e-30, -1e-30, 1e-17, -1e-9};
  d[kind % 3] = small[kind / 3 % 6];
  if (kind % 2) d[(kind + 1) % 3] = small[kind / 5 % 6];
  return d;
}

TEST(TruthWalks, RaysAnywhereMeetTheSame) {
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const auto triangles = soup(400, scale, uint64_t(1 / scale) + 3);
    Pcg random(4);
    std::vector<TruthRay> rays;
    for (int i = 0; i < 2000; ++i)
      rays.push_back(
          {.origin = randomPoint(random, scale),
           .direction = i % 3 ? randomPoint(random, i % 2 ? 1 : 1e-5) : degenerate(random, i / 3),
           .tMax = kForever});
    EXPECT_GT(expectSame(triangles, rays, scale, keepAll), 700u) << scale;
  }
}

TEST(TruthWalks, NeighboursMeetTheSame) {
  const auto triangles = soup(2000, 1, 8);
  Pcg random(9);
  std::vector<TruthRay> rays;
  for (int bundle = 0; bundle < 60; ++bundle) {
    const dvec3 origin = randomPoint(random, 1), direction = randomPoint(random, 1);
    for (int i = 0; i < 8; ++i) {
      // From a point, parallel from a patch, from a patch to a point.
      const dvec3 off = randomPoint(random, 0.02);
      TruthRay ray{.origin = origin, .direction = direction, .tMax = bundle % 2 ? kForever : 0.7};
      if (bundle % 3 != 0) ray.origin += off;
      if (bundle % 3 == 0) ray.direction += off;
      if (bundle % 3 == 2) ray.direction -= off;
      rays.push_back(ray);
    }
  }
  EXPECT_GT(expectSame(triangles, rays, 1, keepAll), 1000u);
}

TEST(TruthWalks, RaysOfAllDirectionsWalkBesideOneAnother) {
  const auto triangles = soup(300, 1, 15);
  const Bvh bvh(triangles, 2);
  Pcg random(16);
  std::vector<TruthRay> rays;
  for (int i = 0; i < 64; ++i)
    rays.push_back(
        {.origin = randomPoint(random, 1), .direction = randomPoint(random, 1), .tMax = kForever});
  // One is infinitely short, one has no direction at all.
  rays[11].tMax = 0;
  rays[21].direction = dvec3(0);
  std::vector<TruthHit> expected;
  for (const BoxWalks& walks : allWalks()) {
    RaysTogether together(rays, keepAll);
    together.find(bvh, walks);
    for (size_t i = 0; i < rays.size(); ++i) {
      Bvh::hitsOfAll(triangles, rays[i], keepAll, expected);
      EXPECT_TRUE(same(together.hits[i], expected)) << i;
      EXPECT_EQ(together.ended[i], 1u);
    }
  }
}

TEST(TruthWalks, TrianglesSmallerThanFloatsCanTellAreMet) {
  Pcg random(21);
  std::vector<TruthTriangle> triangles;
  std::vector<TruthRay> rays;
  for (int i = 0; i < 500; ++i) {
    const dvec3 at = randomPoint(random, 1);
    TruthTriangle& t = triangles.emplace_back();
    for (auto& corner : t.corners) corner = at + randomPoint(random, i % 2 ? 1e-7 : 1e-10);
    const dvec3 middle = (t.corners[0] + t.corners[1] + t.corners[2]) / 3.0;
    const dvec3 from = randomPoint(random, 1);
    rays.push_back({.origin = from, .direction = (middle - from) * (i % 3 + 0.7), .tMax = 2});
  }
  EXPECT_GT(expectSame(triangles, rays, 1, keepAll), 450u);
}

TEST(TruthWalks, RaysInPlanesAlongEdgesAndThroughCornersMeetTheSame) {
  const auto triangles = grid(3);
  Pcg random(6);
  std::vector<TruthRay> rays;
  for (int i = 0; i < 900; ++i) {
    const dvec3 from = glm::round(randomPoint(random, 4)), to = glm::round(randomPoint(random, 4));
    TruthRay ray{.origin = from, .direction = to - from, .tMax = i % 2 ? 1 : kForever};
    if (ray.direction == dvec3(0)) continue;
    if (i % 3 == 1) ray.origin += dvec3(0.5, 0, 0.25), ray.direction *= dvec3(1, -0.0, 0);
    if (i % 3 == 2) ray.direction += randomPoint(random, 1e-12);
    if (ray.direction == dvec3(0)) continue;
    rays.push_back(ray);
  }
  EXPECT_GT(expectSame(triangles, rays, 8, keepAll), 1000u);
}

TEST(TruthWalks, WhatStopsAndWhatIsNearestEndsEachRayForItself) {
  const auto triangles = soup(1500, 1, 12);
  Pcg random(13);
  std::vector<TruthRay> rays;
  for (int i = 0; i < 800; ++i) {
    if (i % 8 == 0)
      rays.push_back({.origin = randomPoint(random, 1),
                      .direction = randomPoint(random, 1),
                      .tMax = kForever});
    else
      rays.push_back(rays.back());
    rays.back().direction += randomPoint(random, 1e-2);
    rays.back().tie = i % 5 ? 0 : 0.1;
  }
  for (const auto least : {Bvh::Verdict::Nearest, Bvh::Verdict::Stop})
    EXPECT_GT(expectSame(triangles, rays, 1,
                         [&](const TruthHit& hit) {
                           if (hit.triangle % 5 == 0) return Bvh::Verdict::Ignore;
                           return hit.triangle % 3 == 0 ? least : Bvh::Verdict::Keep;
                         }),
              500u);
}

TEST(TruthWalks, ARayDoesNotMeetTheTriangleItStartsOn) {
  auto triangles = soup(50, 1, 2);
  triangles.push_back({.corners = {dvec3(-9, -9, 0.5), dvec3(9, -9, 0.5), dvec3(0, 9, 0.5)}});
  const auto own = uint32_t(triangles.size() - 1);
  const Bvh bvh(triangles, 10);
  const TruthRay ray{
      .origin = dvec3(0), .direction = dvec3(0.1, 0.1, 1), .tMax = kForever, .own = own};
  TruthRay other = ray;
  other.own = kNone;
  const TruthRay both[] = {ray, other};
  for (const BoxWalks& walks : allWalks()) {
    RaysTogether together(both, keepAll);
    together.find(bvh, walks);
    const auto& hits = together.hits;
    const auto holds = [&](const std::vector<TruthHit>& list) {
      return std::ranges::any_of(list, [&](const TruthHit& h) { return h.triangle == own; });
    };
    EXPECT_FALSE(holds(hits[0]));
    EXPECT_TRUE(holds(hits[1]));
  }
}

TEST(TruthWalks, EachRayOfAPacketHasATriangleOfItsOwn) {
  const TruthTriangle wall{.corners = {dvec3(-9, -9, 1), dvec3(9, -9, 1), dvec3(0, 9, 1)}};
  // More triangles in a leaf than rays, and fewer.
  for (const size_t walls : {2u, 4u}) {
    const std::vector<TruthTriangle> triangles(walls, wall);
    const Bvh bvh(triangles, 10);
    std::vector<TruthRay> rays(3, {.origin = dvec3(0), .direction = dvec3(0.1, 0.1, 1), .tMax = 2});
    for (uint32_t i = 0; i < 2; ++i) rays[i].own = i;
    for (const BoxWalks& walks : allWalks()) {
      RaysTogether together(rays, keepAll);
      together.find(bvh, walks);
      for (uint32_t i = 0; i < 3; ++i) {
        EXPECT_EQ(together.hits[i].size(), i < 2 ? walls - 1 : walls);
        for (const TruthHit& hit : together.hits[i]) EXPECT_NE(hit.triangle, rays[i].own);
      }
    }
  }
}

TEST(TruthWalks, TreesOfNothingOfOneAndOfTheSameOverAndOver) {
  std::vector<TruthRay> rays;
  Pcg random(3);
  for (int i = 0; i < 40; ++i)
    rays.push_back({.origin = dvec3(0.1, 0.1, -1),
                    .direction = dvec3(0, 0, 1) + randomPoint(random, 0.3),
                    .tMax = 3});
  const TruthTriangle one{.corners = {dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(0, 1, 0)}};
  EXPECT_EQ(expectSame({}, rays, 3, keepAll), 0u);
  const size_t once = expectSame({one}, rays, 3, keepAll);
  EXPECT_GT(once, 10u);
  EXPECT_EQ(expectSame(std::vector(1000, one), rays, 3, keepAll), 1000 * once);
}

TEST(TruthWalks, PositionsFoundTogetherAreThoseFoundAlone) {
  for (const char* name : {"window", "layers", "spheres_quads:quads=50", "penumbra"}) {
    const Scene scene = makeScene(name);
    const RayScene rays(scene, 32, 32);
    const LightVisibility lights(rays);
    const AreaSampling sampling{.first = 64, .most = 64};
    std::vector<Sampler> together(13, Sampler(rays, lights));
    Sampler alone(rays, lights);
    for (uint32_t row = 1; row < 32; row += 9) {
      std::vector<glm::dvec2> positions;
      for (uint32_t i = 0; i < together.size(); ++i) positions.push_back({2.4 * i + 0.2, row});
      Sampler::find(together, positions, sampling);
      for (size_t i = 0; i < together.size(); ++i) {
        alone.find(positions[i].x, positions[i].y, sampling);
        ASSERT_EQ(together[i].layers().size(), alone.layers().size()) << name;
        EXPECT_EQ(together[i].color(), alone.color()) << name;
        for (size_t l = 0; l < alone.layers().size(); ++l)
          for (uint32_t light = 0; light < rays.lights(); ++light)
            EXPECT_EQ(together[i].layers()[l].answers[light].visible,
                      alone.layers()[l].answers[light].visible)
                << name;
      }
    }
    uint64_t counted = 0;
    for (const Sampler& s : together) counted += s.rays();
    EXPECT_EQ(counted, alone.rays()) << name;
  }
}

}  // namespace
}  // namespace sb
