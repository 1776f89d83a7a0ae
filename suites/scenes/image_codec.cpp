#include "suites/scenes/image_codec.h"

#include <cstring>

// Static: other parts of the program may hold stb of their own.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace sb {
namespace {

// stb fills what is missing of a cut PNG with whatever zlib left; its chunk list tells better.
bool pngComplete(std::span<const uint8_t> bytes) {
  size_t offset = 8;
  while (offset + 12 <= bytes.size()) {
    const uint8_t* p = bytes.data() + offset;
    const size_t length = size_t(p[0]) << 24 | size_t(p[1]) << 16 | size_t(p[2]) << 8 | p[3];
    if (length > bytes.size() - offset - 12) return false;
    if (std::memcmp(p + 4, "IEND", 4) == 0) return true;
    offset += 12 + length;
  }
  return false;
}

}  // namespace

ImageFormat imageFormat(std::span<const uint8_t> bytes) {
  constexpr uint8_t kPng[] = {0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A};
  constexpr uint8_t kJpeg[] = {0xFF, 0xD8, 0xFF};
  if (bytes.size() >= 8 && std::memcmp(bytes.data(), kPng, 8) == 0) return ImageFormat::Png;
  if (bytes.size() >= 3 && std::memcmp(bytes.data(), kJpeg, 3) == 0) return ImageFormat::Jpeg;
  return ImageFormat::Unknown;
}

Image decodeImage(std::span<const uint8_t> bytes, size_t maxPixels, std::string& error) {
  Image image;
  const ImageFormat format = imageFormat(bytes);
  if (format == ImageFormat::Unknown) return error = "is neither PNG nor JPEG", image;
  if (format == ImageFormat::Png && !pngComplete(bytes)) return error = "is cut off", image;
  int width = 0, height = 0, channels = 0;
  const auto* data = bytes.data();
  const int size = int(bytes.size());
  if (!stbi_info_from_memory(data, size, &width, &height, &channels) || width < 1 || height < 1)
    return error = std::string("cannot be decoded: ") + stbi_failure_reason(), image;
  if (size_t(width) * size_t(height) > maxPixels)
    return error = "has " + std::to_string(width) + "x" + std::to_string(height) +
                   " pixels, more than the " + std::to_string(maxPixels) + " left to read",
           image;
  uint8_t* pixels = stbi_load_from_memory(data, size, &width, &height, &channels, 4);
  if (!pixels)
    return error = std::string("cannot be decoded: ") + stbi_failure_reason(), image;
  image.width = uint32_t(width);
  image.height = uint32_t(height);
  image.rgba.assign(pixels, pixels + size_t(width) * size_t(height) * 4);
  stbi_image_free(pixels);
  return image;
}

std::vector<uint8_t> encodePng(const Image& image) {
  std::vector<uint8_t> png;
  const auto append = [](void* context, void* data, int size) {
    auto& out = *static_cast<std::vector<uint8_t>*>(context);
    const auto* bytes = static_cast<const uint8_t*>(data);
    out.insert(out.end(), bytes, bytes + size);
  };
  stbi_write_png_to_func(append, &png, int(image.width), int(image.height), 4, image.rgba.data(),
                         int(image.width) * 4);
  return png;
}

}  // namespace sb
