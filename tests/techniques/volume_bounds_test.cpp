// What culling of shadow volumes stands on: bounds of volumes, rectangles of lights.
#include "techniques/volumes/culling/volume_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "suites/scenes/procedural/parts/random.h"
#include "techniques/scene/camera.h"
#include "techniques/volumes/culling/light_rectangle.h"

namespace sb {
namespace {

glm::dvec3 randomPoint(Pcg& random, double room) {
  const double x = random.uniform(-room, room), y = random.uniform(-room, room);
  return {x, y, random.uniform(-room, room)};
}

TEST(VolumeBounds, NoPointOfAVolumeThatIsSeenIsCulled) {
  Pcg random(5);
  Camera camera;
  camera.farPlane = 20;
  const std::vector<HalfSpace> frustum = frustumHalfSpaces(camera, 1.25);
  const auto seen = [&](const glm::dvec3& p) {
    return std::ranges::all_of(
        frustum, [&](const HalfSpace& h) { return glm::dot(h.normal, p) + h.offset >= 0; });
  };
  int culled = 0, shown = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec3 middle = randomPoint(random, 12), half = glm::abs(randomPoint(random, 2));
    const bool local = random.below(2);
    const glm::dvec3 place = randomPoint(random, 12);
    const VolumeBounds bounds{{middle - half, middle + half},
                              local ? glm::dvec4(place, 1) : glm::dvec4(glm::normalize(place), 0),
                              random.below(2) ? random.uniform(0, local ? 2 : 0.5) : 0};
    if (!bounds.liesOutside(frustum)) {
      ++shown;
      continue;
    }
    ++culled;
    for (int k = 0; k < 200; ++k) {
      const glm::dvec3 p = middle + half * randomPoint(random, 1);
      // From any point of the light.
      glm::dvec3 aside = randomPoint(random, 1);
      aside *= bounds.lightRadius / std::max(1.0, glm::length(aside));
      const glm::dvec3 away = p * bounds.light.w - glm::dvec3(bounds.light) + aside;
      ASSERT_FALSE(seen(p + away * random.uniform(0, 4)));
    }
  }
  EXPECT_GT(culled, 1000);
  EXPECT_GT(shown, 1000);
}

TEST(VolumeBounds, AVolumeThatEndsHoldsWhatItReaches) {
  const VolumeBounds lamp{{{-1, 1, -1}, {1, 2, 1}}, {0, 4, 0, 1}};
  const Box box = lamp.within(8);
  EXPECT_LE(box.low.y, -4) << "straight below the lamp, between the corners";
  EXPECT_GT(box.low.y, -4 - 1e-9);
  EXPECT_EQ(box.high.y, 2);
  const VolumeBounds sun{{{-1, 1, -1}, {1, 2, 1}}, {0, 1, 0, 0}};
  EXPECT_EQ(sun.within(8).low.y, -7);
}

TEST(VolumeBounds, NoPointOfAVolumeLiesBeyondItsBox) {
  Pcg random(9);
  int around = 0;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 middle = randomPoint(random, 5), half = glm::abs(randomPoint(random, 2));
    const glm::dvec3 lamp = randomPoint(random, 5);
    const double reach = random.uniform(1, 12);
    const VolumeBounds bounds{{middle - half, middle + half}, glm::dvec4(lamp, 1)};
    const Box box = bounds.within(reach);
    around += box.high.x - box.low.x >= 2 * reach;
    for (int k = 0; k < 200; ++k) {
      const glm::dvec3 way = middle + half * randomPoint(random, 1) - lamp;
      const double length = glm::length(way);
      if (length > reach) continue;
      const glm::dvec3 end = lamp + way * (reach / length);
      ASSERT_TRUE(glm::all(glm::lessThanEqual(box.low, end + 1e-9)));
      ASSERT_TRUE(glm::all(glm::greaterThanEqual(box.high, end - 1e-9)));
    }
  }
  EXPECT_LT(around, 400) << "boxes say nothing";
}

/// Pixels of the frustum's points within a sphere, by random points of it.
void expectHolds(const Camera& camera, const Sphere& sphere, Pcg& random) {
  constexpr rhi::Extent2D kSize = {80, 60};
  const auto rect = sphereRectangle(camera, kSize, sphere);
  const CameraMatrices matrices = cameraMatrices(camera, 80.0 / 60);
  for (int i = 0; i < 400; ++i) {
    glm::dvec3 way = randomPoint(random, 1);
    if (glm::length(way) > 1) continue;
    const glm::dvec4 clip =
        matrices.viewProjection * glm::dvec4(sphere.center + way * sphere.radius, 1);
    if (clip.w <= 0 || std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w || clip.z < 0 ||
        clip.z > clip.w || !rect)
      continue;
    const double x = (0.5 + 0.5 * clip.x / clip.w) * kSize.width;
    const double y = (0.5 + 0.5 * clip.y / clip.w) * kSize.height;
    ASSERT_GE(x, rect->x);
    ASSERT_LE(x, rect->x + double(rect->width));
    ASSERT_GE(y, rect->y);
    ASSERT_LE(y, rect->y + double(rect->height));
  }
}

TEST(LightRectangle, HoldsWhatIsSeenOfASphere) {
  Pcg random(11);
  Camera camera;
  int parts = 0;
  for (int i = 0; i < 2000; ++i) {
    camera.orthographic = i % 3 == 0;
    camera.halfHeight = 3;
    const glm::dvec3 center = randomPoint(random, 8);
    const Sphere sphere{center, random.uniform(0.05, 4)};
    parts += sphereRectangle(camera, {80, 60}, sphere).has_value();
    expectHolds(camera, sphere, random);
  }
  EXPECT_GT(parts, 1000);
}

TEST(LightRectangle, IsTight) {
  Camera camera;
  camera.fovY = 1.5707963267948966;
  // Tangents at 45 degrees of the middle of the view: half the picture's height and a pixel more.
  const auto rect = sphereRectangle(camera, {100, 100}, {{0, 0, -4}, 4 / std::sqrt(5.0)});
  ASSERT_TRUE(rect);
  EXPECT_EQ(rect->x, 24);
  EXPECT_EQ(rect->y, 24);
  EXPECT_EQ(rect->width, 52u);
  EXPECT_EQ(rect->height, 52u);
  EXPECT_FALSE(sphereRectangle(camera, {100, 100}, {{0, 0, -1}, 2}));
  EXPECT_EQ(sphereRectangle(camera, {100, 100}, {{90, 0, -4}, 1})->width, 1u) << "beside the view";
}

}  // namespace
}  // namespace sb
