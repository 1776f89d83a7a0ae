// Density and phase function of media, their integer lattice, and how media are packed for shaders.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "techniques/scene/medium_data.h"

namespace sb {
namespace {

using glm::dvec3;
using glm::uvec3;

TEST(Medium, TheLatticeIsTheWorkedIntegers) {
  // First output of PCG4D, 24 bits, worked out by a program of its own.
  EXPECT_EQ(gpu::latticeValue(uvec3(0), 0) * 0x1p24, 983800);
  EXPECT_EQ(gpu::latticeValue(uvec3(1, 2, 3), 4) * 0x1p24, 3547853);
  EXPECT_EQ(gpu::latticeValue(uvec3(~0u, 5, ~1u), 77) * 0x1p24, 887385);
}

TEST(Medium, NoiseMeetsItsLatticeAndRisesByWholeCells) {
  for (const dvec3 p : {dvec3(1, 2, 3), dvec3(-1, 5, -2), dvec3(0)})
    EXPECT_EQ(gpu::valueNoise(p, 0, 9), gpu::latticeValue(uvec3(glm::ivec3(p)), 9));
  const dvec3 p(1.25, 3.5, -0.75);
  EXPECT_EQ(gpu::valueNoise(p, 2, 9), gpu::valueNoise(p - dvec3(0, 2, 0), 0, 9));
  // Half way along an edge the quintic fade is a half.
  EXPECT_EQ(gpu::valueNoise({4.5, 2, 3}, 0, 9),
            (gpu::latticeValue({4, 2, 3}, 9) + gpu::latticeValue({5, 2, 3}, 9)) / 2);
  double sum = 0, low = 1, high = 0;
  for (int i = 0; i < 20000; ++i) {
    const double n = gpu::fractalNoise(dvec3(0.37, 0.71, 0.13) * double(i), 0, 1);
    sum += n, low = std::min(low, n), high = std::max(high, n);
  }
  EXPECT_GE(low, 0);
  EXPECT_LT(high, 1);
  EXPECT_NEAR(sum / 20000, 0.5, 0.01);
}

TEST(Medium, SmokeKeepsToItsColumnAndRises) {
  Medium m{.kind = MediumKind::Smoke, .seed = 3};
  double greatest = 0;
  for (int i = 0; i < 40000; ++i) {
    const dvec3 q = glm::fract(dvec3(0.7548776662, 0.5698402909, 0.4656712) * double(i));
    const double d = gpu::smokeDensity(smokeShape(m), q);
    ASSERT_GE(d, 0);
    ASSERT_LT(d, 1);
    greatest = std::max(greatest, d);
    const glm::dvec2 aside(q.x - 0.5, q.z - 0.5);
    if (glm::length(aside) > 0.12 + 0.25 * q.y + 0.085) ASSERT_EQ(d, 0);
  }
  EXPECT_GT(greatest, 0.4);
  EXPECT_EQ(gpu::smokeDensity(smokeShape(m), {0.5, 0, 0.5}), 0);
  EXPECT_EQ(gpu::smokeDensity(smokeShape(m), {0.5, 1, 0.5}), 0);
  // The noise rises by two cells a second, of six in the box.
  m.time = 0.75;
  EXPECT_EQ(smokeShape(m).drift, 1u);
  EXPECT_EQ(smokeShape(m).shift, 0.5);
  Medium other = m;
  other.seed = 4;
  EXPECT_NE(smokeShape(other).turn, smokeShape(m).turn);
}

TEST(Medium, SinesNeedNoTable) {
  for (double x = -3; x < 3; x += 0.001)
    EXPECT_NEAR(gpu::sinTurns(x), std::sin(2 * std::numbers::pi * x), 6e-8) << x;
}

TEST(Medium, PhaseFunctionsScatterAllThatTheyTake) {
  constexpr int kSteps = 200'000;
  for (const double g : {-0.9, -0.5, 0.0, 0.3, 0.9}) {
    double sum = 0, mean = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double cosine = -1 + 2 * (i + 0.5) / kSteps;
      const double p = gpu::henyeyGreenstein(g, cosine) * 4 * std::numbers::pi / kSteps;
      sum += p, mean += p * cosine;
    }
    EXPECT_NEAR(sum, 1, 1e-5) << g;
    EXPECT_NEAR(mean, g, 1e-5);
  }
  EXPECT_DOUBLE_EQ(gpu::henyeyGreenstein(0, 0.3), 0.25 / std::numbers::pi);
  for (const double g : {-1.0, 1.0}) EXPECT_EQ(gpu::henyeyGreenstein(g, g), 0) << g;
}

TEST(Medium, GridsAreTrilinearBetweenMiddles) {
  Medium m{.kind = MediumKind::Grid, .extinction = {1, 2, 0}, .size = {2, 3, 4}};
  for (int i = 0; i < 24; ++i) m.density.push_back(float(i));
  // x counts 1, y 2, z 6.
  EXPECT_EQ(gridDensity(m, {0.25, 0.5, 0.125}), 2);
  EXPECT_DOUBLE_EQ(gridDensity(m, {0.5, 0.5, 0.5}), 0.5 + 2 + 6 * 1.5);
  EXPECT_EQ(gridDensity(m, {1, 1, 1}), 23) << "constant beyond the outermost";
  EXPECT_EQ(gridDensity(m, {0, 0, 0}), 0);
  EXPECT_EQ(greatestDensity(m), 23);
  m.boxToWorld[1][1] = 3;
  EXPECT_DOUBLE_EQ(greatestDepth(m), 2 * 23 * std::sqrt(11.0));
}

TEST(Medium, ShadersGetRecordsRelativeToTheEye) {
  Medium m{.kind = MediumKind::Smoke,
           .extinction = {1, 2, 3},
           .albedo = {0.5f, 0.25f, 1},
           .anisotropy = 0.75f,
           .seed = 42,
           .time = 1.25};
  m.boxToWorld = glm::dmat4(4);
  m.boxToWorld[3] = {1e7 + 1, 2, 3, 1};
  const std::vector<Medium> media(kMaxMedia, m);
  const gpu::MediaBlock block = mediaBlock(media, {1e7, 0, 0});
  EXPECT_EQ(block.count.x, 16u);
  const gpu::MediumData& d = block.media[15];
  // (x, y, z, 1) = (3, 4, 5, 1) relative to the eye is the cube's (0.5, 0.5, 0.5).
  const glm::vec4 p(3, 4, 5, 1);
  EXPECT_EQ(glm::vec3(glm::dot(d.toBox0, p), glm::dot(d.toBox1, p), glm::dot(d.toBox2, p)),
            glm::vec3(0.5f));
  EXPECT_EQ(d.extinction, glm::vec4(1, 2, 3, 0.75f));
  EXPECT_EQ(glm::vec3(d.albedo), glm::vec3(0.5f, 0.25f, 1));
  EXPECT_EQ(d.ids, glm::uvec4(MEDIUM_SMOKE, 42, 2, 0));
  EXPECT_EQ(d.smoke.y, 0.5f);
  EXPECT_EQ(d.smoke.x, float(smokeShape(m).turn));
  EXPECT_EQ(mediaBlock({}, dvec3(0)).count.x, 0u);
}

}  // namespace
}  // namespace sb
