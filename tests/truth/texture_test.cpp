// Textures by hand: texel centres, wrapping, decoding before filtering, transforms.
#include <gtest/gtest.h>

#include "suites/truth/texture_sampler.h"

namespace sb {
namespace {

/// Red of the texels 0, 51, 102, 153 in a row, alpha the same.
Scene rowOfFour() {
  Scene scene;
  Image image{.name = "row", .width = 4, .height = 1};
  for (int i = 0; i < 4; ++i) {
    const uint8_t v = uint8_t(51 * i);
    image.rgba.insert(image.rgba.end(), {v, 0, 0, v});
  }
  scene.images.push_back(image);
  return scene;
}

double redAt(const TextureSlot& slot, float u, float v = 0.5f) {
  static const Scene scene = rowOfFour();
  return sampleTexture(scene, slot, {u, v}).r;
}

TEST(TruthTexture, TexelCentresLieAtHalfIntegers) {
  const TextureSlot slot{.image = 0};
  EXPECT_NEAR(redAt(slot, 0.125f), 0.0, 1e-12);
  EXPECT_NEAR(redAt(slot, 0.375f), 0.2, 1e-12);
  EXPECT_NEAR(redAt(slot, 0.25f), 0.1, 1e-12);
  EXPECT_NEAR(redAt(slot, 0.4375f), 0.25, 1e-12);
}

TEST(TruthTexture, WrapsEachAxis) {
  EXPECT_NEAR(redAt({.image = 0}, 0.0f), 0.3, 1e-12);  // half of the last texel
  EXPECT_NEAR(redAt({.image = 0}, 1.375f), 0.2, 1e-12);
  EXPECT_NEAR(redAt({.image = 0}, -0.625f), 0.2, 1e-12);
  EXPECT_NEAR(redAt({.image = 0, .wrapU = Wrap::ClampToEdge}, 0.0f), 0.0, 1e-12);
  EXPECT_NEAR(redAt({.image = 0, .wrapU = Wrap::ClampToEdge}, 7.0f), 0.6, 1e-12);
  EXPECT_NEAR(redAt({.image = 0, .wrapU = Wrap::MirroredRepeat}, 1.125f), 0.6, 1e-12);
  EXPECT_NEAR(redAt({.image = 0, .wrapU = Wrap::MirroredRepeat}, -0.375f), 0.2, 1e-12);
  EXPECT_NEAR(redAt({.image = 0, .nearest = true}, 3e9f), redAt({.image = 0, .nearest = true}, 0), 1e-12);
}

TEST(TruthTexture, NearestTakesTheTexelThatHoldsThePoint) {
  EXPECT_NEAR(redAt({.image = 0, .nearest = true}, 0.49f), 0.2, 1e-12);
  EXPECT_NEAR(redAt({.image = 0, .nearest = true}, 0.5f), 0.4, 1e-12);
}

TEST(TruthTexture, DecodesBeforeItFilters) {
  const Scene scene = rowOfFour();
  const auto decode = [](double v) { return std::pow((v + 0.055) / 1.055, 2.4); };
  const auto v = sampleTexture(scene, {.image = 0, .srgb = true}, {0.5f, 0.5f});
  EXPECT_NEAR(v.r, (decode(0.2) + decode(0.4)) / 2, 1e-12);
  EXPECT_NEAR(v.a, 0.3, 1e-12) << "alpha is linear";
}

TEST(TruthTexture, TransformsCoordinates) {
  TextureSlot slot{.image = 0, .nearest = true};
  slot.uvTransform = {glm::vec3(0, 0.5f, 0.25f), glm::vec3(1, 0, 0)};
  EXPECT_NEAR(redAt(slot, 0, 0.5f), 0.4, 1e-12);
}

}  // namespace
}  // namespace sb
