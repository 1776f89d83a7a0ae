// Shares of lights that outlines hide (spec 08), by the code that shaders run, against the
// specification's numbers and areas of clipped polygons, scanned line by line.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "shaders/common/shared_coverage.h"
#include "techniques/scene/light_area.h"
#include "tests/techniques/scanned_share.h"

namespace sb::test {
namespace {

using glm::dvec2;
using glm::vec2;
using glm::vec3;
using gpu::LightSight;

using Outline = std::vector<vec3>;  ///< seen points, counter-clockwise around the occluder

/// Of a light whose patch is the unit disc, or square, in the plane z = 1.
LightSight unitSight(uint32_t seen = SEEN_ROUND) {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, seen};
}

/// Half way to the light.
vec3 at(float x, float y) { return seenPoint(unitSight(), 0.5f * vec3(x, y, 1)); }

/// Of triangles before unitSight(), which sees points where they are.
bool hides(const LightSight& sight, const vec3& a, const vec3& b, const vec3& c) {
  return hidesCentre(sight, a, b, c, gpu::wayToPlane(a, b, c, {0, 0, 1}));
}

/// Of an outline that is a fan around its first point.
float coveredBy(const LightSight& sight, const Outline& outline) {
  float covered = 0;
  for (size_t i = 0; i < outline.size(); ++i)
    covered -= edgeShare(sight, outline[i], outline[(i + 1) % outline.size()]);
  for (size_t i = 1; i + 1 < outline.size(); ++i) {
    const vec3 a = outline[0], b = outline[i], c = outline[i + 1];
    const bool turned = dot(a, cross(b, c)) < 0;
    if (hides(sight, a, b, c)) covered += turned ? -1.0f : 1.0f;
  }
  return covered;
}

std::vector<dvec2> projected(const Outline& outline) {
  std::vector<dvec2> polygon;
  for (const vec3& p : outline) polygon.push_back(dvec2(p.x, p.y) / double(p.z));
  return polygon;
}

/// Around a point, at random distances of the eye: simple, rarely convex.
Outline randomOutline(std::mt19937& random) {
  std::uniform_real_distribution<float> unit(0, 1);
  const vec2 middle(2 * unit(random) - 1, 2 * unit(random) - 1);
  const int corners = 3 + int(random() % 7);
  Outline outline = {};
  for (int i = 0; i < corners; ++i) {
    const float angle = (float(i) + 0.9f * unit(random)) * 6.2831853f / float(corners);
    const float radius = 0.1f + 1.4f * unit(random), z = 0.05f + 0.95f * unit(random);
    outline.push_back(z * vec3(middle + radius * vec2(std::cos(angle), std::sin(angle)), 1));
  }
  return outline;
}

TEST(Coverage, PartsOfChordsAreThoseOfTheSpecification) {
  EXPECT_NEAR(gpu::discPart(0.5f, 0.5f), 0.085211, 1e-6);
  EXPECT_NEAR(gpu::discPart(0.5f, 0.2f), 0.044644, 1e-6);
  EXPECT_NEAR(gpu::discPart(0.5f, 0.5f) - gpu::discPart(0.5f, -0.2f), 0.129855, 1e-6);
  EXPECT_NEAR(gpu::discPart(0.5f, 0.5f) - gpu::discPart(0.5f, 0.2f), 0.040567, 1e-6);
  for (const auto& [d0, share] :
       {std::pair(0.0f, 0.5), {0.25f, 0.342519}, {0.5f, 0.195501}, {0.9f, 0.018693}}) {
    EXPECT_NEAR(2 * gpu::discPart(d0, 9), share, 1e-6) << d0;
    EXPECT_EQ(gpu::discPart(-d0, 9), gpu::discPart(d0, 9));
    // The centre to the left of the edge: what lies beyond it is lit though the centre is not.
    EXPECT_NEAR(std::abs(edgeShare(unitSight(), at(d0, -5), at(d0, 5))), share, 1e-6);
    if (d0 > 0) {
      EXPECT_GT(edgeShare(unitSight(), at(d0, -5), at(d0, 5)), 0);
      EXPECT_NEAR(edgeShare(unitSight(), at(-d0, -5), at(-d0, 5)), -share, 1e-6);
    }
  }
  EXPECT_EQ(gpu::discPart(1, 0.5f), 0);
  EXPECT_EQ(gpu::discPart(0, 0), 0);
}

TEST(Coverage, PolygonsAreThoseOfTheSpecification) {
  const Outline triangle = {at(-0.3f, -0.4f), at(0.9f, -0.2f), at(0.1f, 1.2f)};
  EXPECT_TRUE(hides(unitSight(), triangle[0], triangle[1], triangle[2]));
  EXPECT_NEAR(coveredBy(unitSight(), triangle), 0.287040, 1e-6);
  EXPECT_NEAR(coveredBy(unitSight(), {at(-9, -0.5f), at(9, -0.5f), at(9, 0.5f), at(-9, 0.5f)}),
              0.608998, 1e-6);
  // Wholly beside the light, and over it.
  EXPECT_EQ(coveredBy(unitSight(), {at(2, -1), at(4, -1), at(3, 3)}), 0);
  EXPECT_EQ(coveredBy(unitSight(), {at(-5, -5), at(5, -5), at(0, 9)}), 1);
  for (const uint32_t seen : {SEEN_ROUND, SEEN_SQUARE})
    EXPECT_EQ(coveredBy(unitSight(seen), {at(-5, -5), at(5, -5), at(0, 9)}), 1);
  EXPECT_NEAR(
      coveredBy(unitSight(SEEN_SQUARE), {at(-0.5f, -2), at(0.25f, -2), at(0.25f, 2), at(-0.5f, 2)}),
      0.375, 1e-6);
}

TEST(Coverage, AnyOutlineCoversItsArea) {
  std::mt19937 random(7);
  for (int i = 0; i < 300; ++i) {
    const Outline outline = randomOutline(random);
    for (const uint32_t seen : {SEEN_ROUND, SEEN_SQUARE})
      EXPECT_NEAR(coveredBy(unitSight(seen), outline),
                  scannedShare(projected(outline), seen != SEEN_SQUARE, 8000), 1e-4)
          << i << " " << seen;
  }
}

TEST(Coverage, EdgesAddUp) {
  std::mt19937 random(8);
  for (int i = 0; i < 500; ++i)
    for (const uint32_t seen : {SEEN_ROUND, SEEN_SQUARE}) {
      const LightSight sight = unitSight(seen);
      const Outline o = randomOutline(random);
      const float whole = edgeShare(sight, o[0], o[1]);
      EXPECT_NEAR(edgeShare(sight, o[1], o[0]), -whole, 1e-7);
      const vec3 between = o[0] + 0.3f * (o[1] - o[0]);
      EXPECT_NEAR(edgeShare(sight, o[0], between) + edgeShare(sight, between, o[1]), whole, 2e-6);
    }
}

TEST(Coverage, TheCentreOnAnEdgeOrVertexIsSeenFromOneSideByAll) {
  // Outlines through the centre, exactly and nearly: H and G agree, whatever side is taken.
  for (const float x : {-1e-6f, -1e-30f, 0.0f, 1e-30f, 1e-6f})
    for (const float y : {-1e-6f, 0.0f, 1e-6f}) {
      for (const uint32_t seen : {SEEN_ROUND, SEEN_SQUARE}) {
        const LightSight sight = unitSight(seen);
        EXPECT_NEAR(coveredBy(sight, {at(x, -5), at(5, -5), at(5, 5), at(x, 5)}), 0.5, 1e-5);
        EXPECT_NEAR(coveredBy(sight, {at(x, y), at(5, y), at(5, 5), at(x, 5)}), 0.25, 1e-5)
            << x << " " << y << " " << seen;
        EXPECT_NEAR(
            coveredBy(sight, {at(x, y), at(x, 5), at(-5, 5), at(-5, -5), at(5, -5), at(5, y)}),
            0.75, 1e-5);
      }
    }
}

TEST(Coverage, EdgesThroughTheCentreOfSquaresTakeTheSideThatIsCounted) {
  // To the last bit: nothing is moved aside here.
  for (const vec2 way : {vec2(1, 0), vec2(0, 1), vec2(1, 1), vec2(-1, 1), vec2(0.5f, 1)}) {
    const vec3 a(way, 0.5f), b(-way, 0.5f);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)})
      EXPECT_NEAR(edgeShare(unitSight(SEEN_SQUARE), from, to),
                  gpu::isLeft(gpu::lineThrough(from, to)) ? 0.5 : -0.5, 1e-6)
          << way.x << " " << way.y;
  }
}

TEST(Coverage, WhatLiesBehindTheReceiverOrBeyondTheLightHidesNothing) {
  // A wall beside the axis that goes from behind the receiver to beyond the light; cut off at the
  // light it covers the same.
  const LightSight sight = unitSight();
  const auto wall = [](float z) {
    return Outline{{0.2f * z, -9, z}, {9, -9, z}, {9, 9, z}, {0.2f * z, 9, z}};
  };
  const float expected =
      float(0.5 - std::asin(0.2) / std::numbers::pi - 0.2 * std::sqrt(0.96) / std::numbers::pi);
  EXPECT_NEAR(coveredBy(sight, wall(0.5f)), expected, 1e-6);
  EXPECT_EQ(coveredBy(sight, wall(1.5f)), 0);
  EXPECT_EQ(coveredBy(sight, wall(-0.5f)), 0);
  // Around the axis.
  for (const float z : {1.5f, -1.5f})
    EXPECT_EQ(coveredBy(sight, {{-9, -9, z}, {9, -9, z}, {0, 9, z}}), 0) << z;
  // Along the axis' direction: from z -1 to 3 at x .2 z, which projects to a point of x.
  EXPECT_NEAR(edgeShare(sight, {-0.2f, -9, -1}, {0.6f, 27, 3}),
              edgeShare(sight, {0.2f * 1e-3f, 9e-3f, 1e-3f}, {0.2f, 9, 1}), 1e-6);
  // Directional light has no plane.
  LightSight sun = sight;
  sun.far = 1e30f;
  EXPECT_NEAR(coveredBy(sun, wall(1.5f)), expected, 1e-6);
}

/// What the truth's patch and the shader's rows say of the same light.
void expectSeenAsPatch(const Light& light, const glm::dvec3& toCentre, double tolerance) {
  const bool directional = light.type == LightType::Directional;
  const LightPatch patch = lightPatch(light, toCentre);
  const vec3 axes[3] = {directional ? vec3(patch.u) : vec3(light.halfAxes[0]),
                        directional ? vec3(patch.v) : vec3(light.halfAxes[1]),
                        vec3(light.halfAxes[2])};
  const uint32_t shape = directional ? SHAPE_DISC : uint32_t(light.shape);
  const LightSight sight =
      gpu::lightSight(vec3(patch.centre), axes[0], axes[1], axes[2], shape, directional);
  EXPECT_EQ(sight.seen, patch.round ? SEEN_ROUND : SEEN_SQUARE);
  for (const dvec2 place : {dvec2(0), dvec2(1, 0), dvec2(0, 1), dvec2(-0.6, 0.8)}) {
    const vec3 seen = gpu::seenPoint(sight, vec3(0.25 * (patch.centre + patch.offset(place))));
    EXPECT_NEAR(4 * seen.z, 1, tolerance);
    EXPECT_NEAR(4 * length(vec2(seen.x, seen.y)), glm::length(place), tolerance) << place.x;
  }
  // Counter-clockwise as the light sees it.
  EXPECT_GT(dot(cross(sight.rowX, sight.rowY), vec3(patch.centre)), 0);
}

TEST(Coverage, LightsAreSeenAsTheTruthSeesThem) {
  Light ball{.type = LightType::Point};
  makeSphere(ball, 1);
  expectSeenAsPatch(ball, {0, 2, 0}, 1e-5);
  expectSeenAsPatch(ball, {3, -4, 12}, 1e-5);
  const auto radius = [&](double distance) {
    const LightSight sight = gpu::lightSight(vec3(0, 0, distance), {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                             SHAPE_ELLIPSOID, false);
    return 1 / length(sight.rowX);
  };
  EXPECT_NEAR(radius(2), 1.1547, 1e-4);
  EXPECT_NEAR(radius(10), 1.0050, 1e-4);
  EXPECT_EQ(
      gpu::lightSight({0, 0.5f, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, SHAPE_ELLIPSOID, false).seen,
      SEEN_FROM_WITHIN);
  Light other{.type = LightType::Point, .shape = LightShape::Ellipsoid};
  other.halfAxes =
      glm::dmat3(glm::dvec3(0.5, 0.1, 0), glm::dvec3(-0.2, 1, 0), glm::dvec3(0, 0.1, -0.7));
  expectSeenAsPatch(other, {3, -4, 5}, 1e-5);
  for (const LightShape shape : {LightShape::Disc, LightShape::Rectangle}) {
    other.shape = shape;
    expectSeenAsPatch(other, {3, -4, 5}, 1e-5);
    expectSeenAsPatch(other, {3, -4, -5}, 1e-5);
  }
  EXPECT_EQ(
      gpu::lightSight({20, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, SHAPE_RECTANGLE, false).seen,
      SEEN_SQUARE);
  // In its plane.
  EXPECT_EQ(
      gpu::lightSight({3, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, SHAPE_RECTANGLE, false).seen,
      SEEN_FROM_WITHIN);
  Light sun{.type = LightType::Directional, .direction = {0.25, -1, 0.5}, .angularRadius = 0.05};
  expectSeenAsPatch(sun, {}, 1e-5);
}

TEST(Coverage, TheSizeOfTheSceneDoesNotMatter) {
  std::mt19937 random(9);
  for (int i = 0; i < 50; ++i) {
    const Outline o = randomOutline(random);
    const auto share = [&](float scale) {
      const vec3 c = scale * vec3(1, 2, 4);
      const LightSight sight =
          gpu::lightSight(c, scale * vec3(0.5f, 0, 0), scale * vec3(0, 0.5f, 0),
                          scale * vec3(0, 0, 0.5f), SHAPE_ELLIPSOID, false);
      return edgeShare(sight, seenPoint(sight, scale * vec3(o[0].x, 1, 2)),
                       seenPoint(sight, scale * vec3(o[1].x, 1.5f, 2)));
    };
    EXPECT_NEAR(share(1), share(1000), 1e-5);
    EXPECT_EQ(share(1), share(1024));
  }
}

}  // namespace
}  // namespace sb::test
