// The random numbers on the CPU: the committed vectors, and p = 0 and p = 1 over 2^24 draws (spec
// 17).
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "shaders/common/shared_hash.h"

namespace sb {
namespace {

TEST(Hash, MatchesTheCommittedVectors) {
  // Each line: texel x, y, mesh, instance and triangle key, sample, seed; then four 24-bit numbers.
  std::ifstream file(SHADOWBENCH_SOURCE_DIR "/tests/techniques/hash_vectors.txt");
  ASSERT_TRUE(file);
  size_t lines = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream in(line);
    uint32_t x, y, mesh, instance, triangle, sample, seed, numbers[4];
    in >> x >> y >> mesh >> instance >> triangle >> sample >> seed;
    for (uint32_t& n : numbers) in >> n;
    ASSERT_TRUE(in) << line;
    const glm::vec4 xi =
        gpu::randomNumbers(x, y, gpu::surfaceKey(mesh, instance, triangle), sample, seed);
    for (int c = 0; c < 4; ++c) EXPECT_EQ(xi[c], float(numbers[c]) * 0x1p-24f) << line;
    ++lines;
  }
  EXPECT_EQ(lines, 64u);
}

TEST(Hash, ZeroNeverAndOneAlwaysBlocks) {
  // 2^24 draws: 2048 x 2048 texels, four numbers each. The rule is xi < p.
  double sum = 0;
  for (uint32_t y = 0; y < 2048; ++y)
    for (uint32_t x = 0; x < 2048; ++x) {
      const glm::vec4 xi = gpu::randomNumbers(x, y, 12345, 0, 1);
      for (int c = 0; c < 4; ++c) {
        ASSERT_FALSE(xi[c] < 0.0f);
        ASSERT_TRUE(xi[c] < 1.0f);
        sum += xi[c];
      }
    }
  // The mean of n uniform numbers: sigma 1 / sqrt(12 n).
  EXPECT_NEAR(sum * 0x1p-24, 0.5, 4 / std::sqrt(12.0 * 0x1p24));
}

}  // namespace
}  // namespace sb
