// Lights with an extent as receivers see them, and the points that they are sampled at.
#include "techniques/scene/light_area.h"

#include <gtest/gtest.h>

#include <set>

#include "techniques/scene/light_data.h"

namespace sb {
namespace {

using glm::dvec2;
using glm::dvec3;

TEST(LightArea, TheSequenceIsThatOfTheSpecification) {
  const dvec2 expected[] = {{0, 0},         {0.5, 0.5},     {0.25, 0.75},   {0.75, 0.25},
                            {0.125, 0.625}, {0.625, 0.125}, {0.375, 0.375}, {0.875, 0.875}};
  for (uint32_t i = 0; i < 8; ++i) EXPECT_EQ(dvec2(sequencePoint(i)) * 0x1p-32, expected[i]) << i;
}

TEST(LightArea, EveryElementaryIntervalHoldsOnePoint) {
  for (uint32_t run = 0; run < 4; ++run)
    for (uint32_t k = 0; k <= 4; ++k) {
      std::set<std::pair<uint32_t, uint32_t>> cells;
      for (uint32_t i = 0; i < 16; ++i) {
        const glm::uvec2 p = sequencePoint(16 * run + i);
        // Shifts by 32 are undefined.
        cells.emplace(uint32_t(uint64_t(p.x) >> (32 - k)), uint32_t(uint64_t(p.y) >> (28 + k)));
      }
      EXPECT_EQ(cells.size(), 16u) << run << " " << k;
    }
  EXPECT_EQ(netPoint(0, 1), dvec2(0.5));
}

TEST(LightArea, PatchesHaveTheirRadiusAndAverage) {
  Light light{.type = LightType::Point};
  makeSphere(light, 2);
  const dvec3 toCentre(1, 2, 4);
  const LightPatch patch = lightPatch(light, toCentre);
  const double d2 = glm::dot(toCentre, toCentre), radius = 2 * std::sqrt(d2 / (d2 - 4));
  EXPECT_NEAR(glm::dot(patch.u, toCentre), 0, 1e-12);
  EXPECT_NEAR(glm::dot(patch.v, toCentre), 0, 1e-12);
  double squares = 0;
  dvec3 sum(0);
  for (uint32_t i = 0; i < 4096; ++i) {
    const dvec3 offset = patch.offset(onDisc(netPoint(i, 4096)));
    EXPECT_LE(glm::length(offset), radius * (1 + 1e-12));
    squares += glm::dot(offset, offset) / 4096;
    sum += offset / 4096.0;
  }
  EXPECT_NEAR(squares, radius * radius / 2, 5e-3) << "uniform over a disc";
  EXPECT_NEAR(glm::length(sum), 0, 1e-3);
  EXPECT_FALSE(patch.inside);
  EXPECT_TRUE(lightPatch(light, {0, 1.9, 0}).inside);
}

TEST(LightArea, TheHullHoldsThePatch) {
  Light light{.type = LightType::Point,
              .shape = LightShape::Ellipsoid,
              .halfAxes = glm::dmat3(dvec3(0.5, 0, 0), dvec3(0, 2, 0), dvec3(0, 0, 1))};
  for (const LightShape shape : {LightShape::Ellipsoid, LightShape::Disc, LightShape::Rectangle}) {
    light.shape = shape;
    const LightPatch patch = lightPatch(light, {1, 3, 4});
    std::array<dvec3, 8> corners{};
    const size_t count = patch.hull(corners);
    const dvec3 normal = glm::cross(patch.u, patch.v);
    for (uint32_t i = 0; i < 256; ++i) {
      const dvec2 square = netPoint(i, 256);
      const dvec3 p = patch.centre + patch.offset(patch.round ? onDisc(square) : onSquare(square));
      for (size_t c = 0; c < count; ++c) {
        const dvec3 side = corners[(c + 1) % count] - corners[c];
        EXPECT_GE(glm::dot(normal, glm::cross(side, p - corners[c])), -1e-9);
      }
    }
  }
}

TEST(LightArea, ShadersGetTheShape) {
  Light light{.type = LightType::Point};
  EXPECT_EQ(lightData(light, 0, dvec3(0)).shape.x, SHAPE_POINT);
  light.shape = LightShape::Rectangle;
  light.halfAxes = glm::dmat3(dvec3(1, 0, 0), dvec3(0, 2, 0), dvec3(0));
  gpu::LightData d = lightData(light, 0, dvec3(7));
  EXPECT_EQ(d.shape.x, SHAPE_RECTANGLE);
  EXPECT_EQ(d.halfAxis0, glm::vec4(1, 0, 0, 0));
  EXPECT_EQ(d.halfAxis1, glm::vec4(0, 2, 0, 0));
  Light sun{.angularRadius = 0.1};
  d = lightData(sun, 0, dvec3(7));
  EXPECT_EQ(d.shape.x, SHAPE_DISC);
  EXPECT_NEAR(glm::length(d.halfAxis0), std::tan(0.1), 1e-6);
  EXPECT_NEAR(glm::dot(glm::vec3(d.halfAxis0), glm::vec3(0, -1, 0)), 0, 1e-6);
}

TEST(LightArea, NoPointThatIsSeenLiesBeyondTheSeenRadius) {
  Light light{.type = LightType::Point, .shape = LightShape::Ellipsoid};
  light.halfAxes = glm::dmat3(1.5, 0, 0, 0, 1, 0, 0, 0, 0.5);
  double widest = 0;
  for (const double distance : {1.501, 1.6, 2.0, 5.0, 100.0})
    for (uint32_t i = 0; i < 256; ++i) {
      const dvec2 place = netPoint(i, 256);
      const double z = 2 * place.y - 1, r = std::sqrt(1 - z * z), turn = 6.283185307 * place.x;
      const LightPatch patch =
          lightPatch(light, distance * dvec3(r * std::cos(turn), r * std::sin(turn), z));
      const double most = seenRadius(light.shape, lightRadius(light), distance) * (1 + 1e-12);
      for (uint32_t k = 0; k < 16; ++k) {
        const double angle = k * 0.39269908;
        const double aside = glm::length(patch.offset({std::cos(angle), std::sin(angle)}));
        ASSERT_LE(aside, most) << distance;
        widest = std::max(widest, aside / most);
      }
    }
  EXPECT_GT(widest, 0.99) << "it is wider than it need be";
  EXPECT_EQ(seenRadius(LightShape::Disc, 2, 0.5), 2);
  EXPECT_TRUE(std::isinf(seenRadius(LightShape::Ellipsoid, 2, 2)));
}

}  // namespace
}  // namespace sb
