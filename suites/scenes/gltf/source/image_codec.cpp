#include "suites/scenes/gltf/source/image_codec.h"

#include <webp/decode.h>

#include <cstdlib>
#include <cstring>

namespace sb {
namespace {

// What one decoding may still allocate: stb unpacks a deflate stream to its end, however small the
// picture that it is for.
thread_local size_t memoryLeft = 0;

void* takeMemory(void* old, size_t oldSize, size_t size) {
  const size_t more = size > oldSize ? size - oldSize : 0;
  if (more > memoryLeft) return nullptr;
  void* memory = std::realloc(old, size);
  if (memory) memoryLeft -= more;
  return memory;
}

}  // namespace
}  // namespace sb

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
// Sizes are unknown when memory is given back: what was taken stays counted.
#define STBI_MALLOC(size) sb::takeMemory(nullptr, 0, size)
#define STBI_REALLOC_SIZED(old, oldSize, size) sb::takeMemory(old, oldSize, size)
#define STBI_REALLOC(old, size) sb::takeMemory(old, 0, size)
#define STBI_FREE(memory) std::free(memory)
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

namespace {

Image decodeWithStb(std::span<const uint8_t> bytes, ImageSize size, std::string& error) {
  Image image;
  const size_t pixels = size_t(size.width) * size.height;
  // 16 bits a channel, unpacked, converted, and the coefficients of a progressive JPEG.
  memoryLeft = 48 * pixels + 2 * bytes.size() + (size_t(1) << 20);
  int width = 0, height = 0, channels = 0;
  uint8_t* data =
      stbi_load_from_memory(bytes.data(), int(bytes.size()), &width, &height, &channels, 4);
  if (!data)
    return error = std::string("cannot be decoded: ") +
                   (std::strcmp(stbi_failure_reason(), "outofmem") == 0
                        ? "its data unpack to more than its size says"
                        : stbi_failure_reason()),
           image;
  if (uint32_t(width) == size.width && uint32_t(height) == size.height) {
    image.width = size.width;
    image.height = size.height;
    image.rgba.assign(data, data + 4 * pixels);
  } else {
    error = "cannot be decoded: its headers state different sizes";
  }
  stbi_image_free(data);
  return image;
}

Image decodeWebP(std::span<const uint8_t> bytes, ImageSize size, std::string& error) {
  Image image{.width = size.width, .height = size.height};
  image.rgba.resize(size_t(4) * size.width * size.height);
  if (WebPDecodeRGBAInto(bytes.data(), bytes.size(), image.rgba.data(), image.rgba.size(),
                         int(4 * size.width)))
    return image;
  error = "cannot be decoded: it is no sound still WebP picture";
  return {};
}

}  // namespace

Image decodeImage(std::span<const uint8_t> bytes, size_t maxPixels, std::string& error) {
  const ImageFormat format = imageFormat(bytes);
  if (format == ImageFormat::Unknown) return error = "is neither PNG, JPEG nor WebP", Image();
  if (format == ImageFormat::Png && !pngComplete(bytes)) return error = "is cut off", Image();
  const ImageSize size = imageSize(bytes);
  const std::string sides = std::to_string(size.width) + "x" + std::to_string(size.height);
  if (size.width == 0 || size.height == 0)
    return error = "cannot be decoded: its header states no size", Image();
  if (size.width > kMaxImageSide || size.height > kMaxImageSide)
    return error = "has " + sides + " pixels, at most " + std::to_string(kMaxImageSide) +
                   " a side are read",
           Image();
  if (size_t(size.width) * size.height > maxPixels)
    return error = "has " + sides + " pixels, more than the " + std::to_string(maxPixels) +
                   " left to read",
           Image();
  return format == ImageFormat::WebP ? decodeWebP(bytes, size, error)
                                     : decodeWithStb(bytes, size, error);
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
