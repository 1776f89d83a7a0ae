#include "reports/picture.h"

#include <stb/stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "base/atomic_file.h"
#include "reports/exr.h"

namespace report {

std::vector<uint8_t> toSrgb8(const Picture& picture, float exposure) {
  std::vector<uint8_t> out;
  out.reserve(size_t(picture.width) * picture.height * 3);
  for (uint32_t y = picture.height; y-- > 0;)
    for (uint32_t x = 0; x < picture.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const float v = picture.rgba[(size_t(y) * picture.width + x) * 4 + size_t(c)] * exposure;
        const float l = std::isnan(v) ? 0.0f : std::clamp(v, 0.0f, 1.0f);
        const float s = l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1 / 2.4f) - 0.055f;
        out.push_back(uint8_t(std::lround(s * 255)));
      }
  return out;
}

std::string encodePng(uint32_t width, uint32_t height, std::span<const uint8_t> rgb) {
  std::string png;
  auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data), size_t(size));
  };
  if (!stbi_write_png_to_func(append, &png, int(width), int(height), 3, rgb.data(), int(width) * 3))
    throw std::runtime_error("cannot encode a PNG");
  return png;
}

void writePng(const std::filesystem::path& path, const Picture& picture, float exposure) {
  base::writeAtomically(path, encodePng(picture.width, picture.height, toSrgb8(picture, exposure)));
}

void writeExr(const std::filesystem::path& path, const Picture& picture) {
  const ExrLayer layer{"", picture.rgba};
  writeExr(path, picture.width, picture.height, {&layer, 1});
}

std::string contentHash(std::span<const std::byte> bytes) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (std::byte b : bytes) hash = (hash ^ uint64_t(b)) * 0x100000001b3u;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace report
