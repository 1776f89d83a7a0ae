// Wedges hold the penumbrae of their edges (spec 08: the containment theorem, on the hulls that are
// drawn), from anywhere and of any light.
#include "techniques/volumes/wedges/wedge.h"

#include <gtest/gtest.h>

#include <random>

#include "shaders/common/shared_wedge.h"
#include "techniques/scene/light_area.h"

namespace sb::test {
namespace {

using glm::dvec3;
using glm::dvec4;

/// How far within the planes of a hull's triangles a point lies.
double depthIn(const Wedge& wedge, const dvec3& x) {
  double least = 1e300;
  for (uint32_t t = 0; t < WEDGE_VERTICES; t += 3) {
    dvec4 c[3], plane;
    for (uint32_t k = 0; k < 3; ++k) c[k] = wedge.hull[gpu::wedgeCorner(t + k)];
    for (int axis = 0; axis < 4; ++axis) {
      dvec4 unit(0);
      unit[axis] = 1;
      plane[axis] = glm::determinant(glm::dmat4(c[0], c[1], c[2], unit));
    }
    // Counter-clockwise from outside: negative there. Of three ways: all space or none.
    const double size = glm::length(dvec3(plane));
    if (c[0].w == 0)
      EXPECT_GT(plane.w, 0);
    else if (size > 0)
      least = std::min(least, glm::dot(plane, dvec4(x, 1)) / size);
  }
  return least;
}

class WedgeTest : public testing::Test {
 protected:
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(m_random); }
  dvec3 inBox(double half) { return half * dvec3(unit(), unit(), unit()); }
  /// On a light's surface: where penumbrae end.
  dvec3 onSphere() { return glm::normalize(inBox(1)); }

  /// Points that the edge hides from the light's points lie within; true if the wedge holds.
  bool checkEdge(const Light& light, const dvec3& a, const dvec3& b) {
    const dvec3 eye(0);
    const Wedge w = wedge(wedgeLight(light, eye), a, b);
    if (!w.holds) return false;
    for (int k = 0; k < 20; ++k) {
      const dvec3 e = glm::mix(a, b, k < 2 ? double(k) : 0.5 + 0.5 * unit());
      dvec3 away;
      if (light.type == LightType::Directional) {
        const LightPatch patch = lightPatch(light, {});
        const double angle = 3.2 * unit();
        away = -(patch.centre + patch.offset({std::cos(angle), std::sin(angle)}));
      } else {
        dvec3 place = onSphere();
        if (light.shape == LightShape::Disc)
          place = dvec3(onDisc({0.5 + 0.5 * unit(), 0.5 + 0.5 * unit()}), 0);
        if (light.shape == LightShape::Rectangle) place = dvec3(unit() < 0 ? -1 : 1, unit(), 0);
        away = e - (light.position + light.halfAxes * place);
      }
      const double s = std::exp(8 * unit() - 4);
      EXPECT_GE(depthIn(w, e + s * away), -2e-5 * glm::length(e + s * away - light.position)) << s;
      // Toward the light nothing is hidden, but by parts of the edge that are nearer to it.
      outside += depthIn(w, e - 0.5 * away) < 0;
    }
    ++held;
    return true;
  }

  int held = 0, outside = 0;
  std::mt19937 m_random{11};
};

TEST_F(WedgeTest, HoldsThePenumbraOfAnyEdgeOfASphere) {
  int refused = 0;
  for (int i = 0; i < 6000; ++i) {
    Light light{.type = LightType::Point, .position = inBox(2)};
    makeSphere(light, std::exp(2 * unit() - 2));
    const double radius = lightRadius(light);
    const dvec3 a = inBox(4), b = a + std::exp(3 * unit()) * onSphere();
    const bool touches = std::min(glm::distance(a, light.position),
                                  glm::distance(b, light.position)) <= radius * 1.0001;
    const bool holds = checkEdge(light, a, b);
    EXPECT_FALSE(touches && holds);
    refused += !touches && !holds;
  }
  EXPECT_GT(held, 4500);
  EXPECT_GT(outside, 15 * held);
  // The middle may come too near though the ends do not.
  EXPECT_LT(refused, 300);
}

TEST_F(WedgeTest, EdgesThatTouchTheLightHaveNone) {
  Light light{.type = LightType::Point};
  makeSphere(light, 1);
  const WedgeLight w = wedgeLight(light, dvec3(0));
  EXPECT_TRUE(wedge(w, {0, -1.001, 0}, {0.01, -1.5, 0}).holds);
  EXPECT_FALSE(wedge(w, {0, -1.00005, 0}, {0.01, -1.5, 0}).holds);
  EXPECT_FALSE(wedge(w, {0, -0.5, 0}, {1, -1.5, 0}).holds);
  // Its middle does, though its ends do not.
  EXPECT_FALSE(wedge(w, {-2, -0.5, 0}, {2, -0.5, 0}).holds);
}

TEST_F(WedgeTest, HoldsForEveryShapeAndForSuns) {
  for (const LightShape shape : {LightShape::Ellipsoid, LightShape::Rectangle, LightShape::Disc})
    for (int i = 0; i < 500; ++i) {
      Light light{.type = LightType::Point, .position = inBox(1), .shape = shape};
      light.halfAxes = glm::dmat3(inBox(1), inBox(1), inBox(1));
      if (std::abs(glm::determinant(light.halfAxes)) < 0.02) continue;
      if (shape != LightShape::Ellipsoid)  // perpendicular
        light.halfAxes[1] = glm::cross(light.halfAxes[0], light.halfAxes[2]);
      const dvec3 a = light.position + 5.0 * onSphere();
      checkEdge(light, a, a + 2.0 * inBox(1));
    }
  const int local = held;
  EXPECT_GT(local, 1000);
  for (int i = 0; i < 500; ++i) {
    Light sun{.type = LightType::Directional, .direction = onSphere()};
    sun.angularRadius = std::exp(2 * unit() - 4);
    checkEdge(sun, inBox(5), inBox(5));
  }
  EXPECT_GT(held - local, 480);
  EXPECT_GT(outside, 15 * held);
}

TEST_F(WedgeTest, EdgesThatPointAtTheLightHavePyramids) {
  for (int i = 0; i < 200; ++i) {
    Light light{.type = LightType::Point, .position = inBox(1)};
    makeSphere(light, 0.5);
    const dvec3 way = onSphere();
    EXPECT_TRUE(checkEdge(light, light.position + 2.0 * way, light.position + 5.0 * way));
    Light sun{.type = LightType::Directional, .direction = way};
    sun.angularRadius = 0.05;
    EXPECT_TRUE(checkEdge(sun, 2.0 * way, 5.0 * way));
  }
}

}  // namespace
}  // namespace sb::test
