// Rays and triangles: the tree finds exactly what testing every triangle finds (spec 16, validation
// 6), closed meshes are watertight and each crossing counts once, floats find nearly the same
// (validation 7).
#include <gtest/gtest.h>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/truth/rays/ray_scene.h"
#include "suites/truth/rays/watertight.h"
#include "techniques/scene/light_area.h"
#include "tests/truth/ray_soup.h"

namespace sb {
namespace {

using namespace test;

const Bvh::Judge kKeepAll = [](const TruthHit&) { return Bvh::Verdict::Keep; };

TEST(TruthRays, TheTreeEqualsTestingEveryTriangle) {
  size_t found = 0;
  for (const double scale : {1e-3, 1.0, 1e6}) {
    const auto triangles = soup(600, scale, uint64_t(1 / scale) + 7);
    const Bvh bvh(triangles, scale);
    Pcg random(11);
    std::vector<TruthHit> a, b;
    for (int i = 0; i < 3000; ++i) {
      TruthRay ray{.origin = randomPoint(random, scale),
                   .direction = randomPoint(random, 1),
                   .tMin = 0,
                   .tMax = std::numeric_limits<double>::infinity()};
      if (i % 3 == 1) ray.direction = dvec3(0), ray.direction[i % 9 / 3] = i % 2 ? 1 : -1;
      if (i % 3 == 2) {  // a segment to a corner of a triangle
        ray.direction = triangles[size_t(i) % triangles.size()].corners[size_t(i) % 2] - ray.origin;
        ray.tMax = 1;
      }
      bvh.hits(ray, kKeepAll, a);
      Bvh::hitsOfAll(triangles, ray, kKeepAll, b);
      ASSERT_TRUE(same(a, b)) << scale << " ray " << i << ": " << a.size() << " and " << b.size();
      found += a.size();
    }
  }
  EXPECT_GT(found, 10000u);
}

TEST(TruthRays, NearestForgetsWhatLiesBehind) {
  const auto triangles = soup(600, 1, 3);
  const Bvh bvh(triangles, 1);
  const Bvh::Judge judge = [](const TruthHit& hit) {
    if (hit.triangle % 5 == 0) return Bvh::Verdict::Ignore;
    return hit.triangle % 3 == 0 ? Bvh::Verdict::Nearest : Bvh::Verdict::Keep;
  };
  Pcg random(5);
  std::vector<TruthHit> a, b;
  for (int i = 0; i < 3000; ++i) {
    const TruthRay ray{.origin = randomPoint(random, 1),
                       .direction = randomPoint(random, 4),
                       .tMin = 0,
                       .tMax = std::numeric_limits<double>::infinity()};
    bvh.hits(ray, judge, a);
    Bvh::hitsOfAll(triangles, ray, judge, b);
    ASSERT_TRUE(same(a, b)) << i;
    for (size_t k = 0; k + 1 < a.size(); ++k)
      EXPECT_TRUE(a[k].triangle % 3 != 0 || a[k + 1].t == a[k].t);
  }
}

/// A closed ball of triangles whose corners are shared exactly.
std::vector<TruthTriangle> ball(int rings, const dvec3& centre) {
  auto at = [&](int ring, int step) {
    const double theta = 3.14159265358979 * ring / rings, phi = 6.28318530717959 * (step % rings) / rings;
    if (ring == 0 || ring == rings) return centre + dvec3(0, ring == 0 ? 1 : -1, 0);
    return centre + dvec3(std::sin(theta) * std::cos(phi), std::cos(theta),
                          std::sin(theta) * std::sin(phi));
  };
  std::vector<TruthTriangle> list;
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < rings; ++s) {
      const dvec3 a = at(r, s), b = at(r, s + 1), c = at(r + 1, s), d = at(r + 1, s + 1);
      if (r > 0) list.push_back({.corners = {a, b, c}});
      if (r + 1 < rings) list.push_back({.corners = {b, d, c}});
    }
  return list;
}

TEST(TruthRays, EdgesAndCornersOfAClosedMeshCountOnce) {
  const dvec3 centre(0.1, -0.2, 0.3);
  const auto triangles = ball(16, centre);
  const Bvh bvh(triangles, 4);
  std::vector<TruthHit> hits;
  Pcg random(2);
  size_t inside = 0, outside = 0;
  for (const TruthTriangle& t : triangles)
    for (size_t k = 0; k < 3; ++k)
      for (const double along : {0.0, 0.25, 0.5}) {
        // Exactly through a corner, and as nearly through an edge as doubles allow.
        const dvec3 through = t.corners[k] + along * (t.corners[(k + 1) % 3] - t.corners[k]);
        TruthRay ray{.origin = centre + randomPoint(random, 0.2),
                     .direction = dvec3(0),
                     .tMin = 0,
                     .tMax = std::numeric_limits<double>::infinity()};
        ray.direction = through - ray.origin;
        bvh.hits(ray, kKeepAll, hits);
        ASSERT_EQ(hits.size(), 1u) << "from inside";
        ++inside;
        ray.origin = centre + glm::normalize(randomPoint(random, 1)) * 3.0;
        ray.direction = through - ray.origin;
        bvh.hits(ray, kKeepAll, hits);
        ASSERT_EQ(hits.size() % 2, 0u) << "from outside";
        size_t front = 0;
        for (const TruthHit& h : hits) front += h.front;
        ASSERT_EQ(front * 2, hits.size());
        ++outside;
      }
  EXPECT_GT(inside + outside, 5000u);
}

TEST(TruthRays, ASquareHasNoGapAndNoDoubleAlongItsDiagonal) {
  const std::vector<TruthTriangle> square = {
      {.corners = {dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(1, 1, 0)}},
      {.corners = {dvec3(0, 0, 0), dvec3(1, 1, 0), dvec3(0, 1, 0)}}};
  std::vector<TruthHit> hits;
  for (int i = 1; i < 64; ++i) {
    const TruthRay ray{.origin = dvec3(i / 64.0, i / 64.0, 1), .direction = dvec3(0, 0, -1),
                       .tMin = 0, .tMax = 2};
    Bvh::hitsOfAll(square, ray, kKeepAll, hits);
    ASSERT_EQ(hits.size(), 1u) << i;
    EXPECT_EQ(hits[0].t, 1);
    EXPECT_TRUE(hits[0].front);
  }
}

TEST(TruthRays, FloatsFindTheSameButForAFewPixels) {
  const auto triangles = ball(24, dvec3(0.1, 0.05, -3));
  size_t differ = 0;
  constexpr int kSize = 192;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const dvec3 d((x + 0.5) / kSize - 0.5, (y + 0.5) / kSize - 0.5, -1);
      const ShearedRay<double> exact(dvec3(0), d);
      const ShearedRay<float> rough(glm::vec3(0), glm::vec3(d));
      size_t exactHits = 0, roughHits = 0;
      for (const TruthTriangle& t : triangles) {
        exactHits += intersect(exact, t.corners).has_value();
        roughHits += intersect(rough, {glm::vec3(t.corners[0]), glm::vec3(t.corners[1]),
                                       glm::vec3(t.corners[2])})
                         .has_value();
      }
      differ += exactHits != roughHits;
    }
  EXPECT_LE(differ, size_t(1e-4 * kSize * kSize));
}

TEST(TruthRays, TheSceneReachesToTheRimsOfItsLamps) {
  Scene scene = floorScene(false);
  scene.cameras[0].toWorld[3] = {0, 0.5, 0, 1};
  Light lamp = pointLight({0, 20, 0});
  makeSphere(lamp, 3);
  addLight(scene, lamp);
  EXPECT_EQ(RayScene(scene, 4, 4).extent(), 22.5);
}

}  // namespace
}  // namespace sb
