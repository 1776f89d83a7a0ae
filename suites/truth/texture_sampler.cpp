#include "suites/truth/texture_sampler.h"

#include <array>
#include <cmath>

namespace sb {
namespace {

int wrapped(int i, int size, Wrap wrap) {
  switch (wrap) {
    case Wrap::ClampToEdge: return std::min(std::max(i, 0), size - 1);
    case Wrap::MirroredRepeat: {
      const int period = 2 * size;
      const int at = ((i % period) + period) % period;
      return at < size ? at : period - 1 - at;
    }
    default: return ((i % size) + size) % size;
  }
}

double decodeSrgb(int byte) {
  static const std::array<double, 256> kTable = [] {
    std::array<double, 256> table;
    for (size_t i = 0; i < 256; ++i) {
      const double v = double(i) / 255;
      table[i] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    return table;
  }();
  return kTable[size_t(byte)];
}

glm::dvec4 texel(const Image& image, const TextureSlot& slot, int x, int y) {
  const int w = int(image.width), h = int(image.height);
  const size_t at = 4 * (size_t(wrapped(y, h, slot.wrapV)) * image.width +
                         size_t(wrapped(x, w, slot.wrapU)));
  glm::dvec4 v;
  for (int c = 0; c < 4; ++c) {
    const int byte = image.rgba[at + size_t(c)];
    v[c] = slot.srgb && c < 3 ? decodeSrgb(byte) : byte / 255.0;
  }
  return v;
}

/// Far outside the picture the integer texel would overflow: repeats are dropped first.
double reduced(double at, int size) {
  const double period = 2.0 * size;
  return std::abs(at) < 1e8 ? at : at - std::floor(at / period) * period;
}

}  // namespace

glm::dvec4 sampleTexture(const Scene& scene, const TextureSlot& slot, const glm::dvec2& uv) {
  const Image& image = scene.images[slot.image];
  const glm::dvec3 h(uv, 1);
  const double u = glm::dot(glm::dvec3(slot.uvTransform[0]), h);
  const double v = glm::dot(glm::dvec3(slot.uvTransform[1]), h);
  const double x = reduced(u * image.width, int(image.width));
  const double y = reduced(v * image.height, int(image.height));
  if (slot.nearest) return texel(image, slot, int(std::floor(x)), int(std::floor(y)));
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
  const double fx = x - 0.5 - left, fy = y - 0.5 - top;
  const int x0 = int(left), y0 = int(top);
  const glm::dvec4 above = glm::mix(texel(image, slot, x0, y0), texel(image, slot, x0 + 1, y0), fx);
  const glm::dvec4 below =
      glm::mix(texel(image, slot, x0, y0 + 1), texel(image, slot, x0 + 1, y0 + 1), fx);
  return glm::mix(above, below, fy);
}

}  // namespace sb
