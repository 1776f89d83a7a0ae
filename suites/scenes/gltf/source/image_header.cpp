// What the first bytes of a picture say, before a decoder takes memory for it.
#include <webp/decode.h>

#include <cstring>

#include "suites/scenes/gltf/source/image_codec.h"

namespace sb {
namespace {

using Bytes = std::span<const uint8_t>;

uint32_t bigEndian(Bytes bytes, size_t at, size_t count) {
  uint32_t value = 0;
  for (size_t i = 0; i < count; ++i) value = value << 8 | bytes[at + i];
  return value;
}

bool begins(Bytes bytes, size_t at, std::string_view magic) {
  return bytes.size() >= at + magic.size() &&
         std::memcmp(bytes.data() + at, magic.data(), magic.size()) == 0;
}

// The first frame header (SOFn) of a JPEG.
ImageSize jpegSize(Bytes bytes) {
  size_t at = 2;
  while (at + 4 <= bytes.size()) {
    if (bytes[at] != 0xFF) return {};
    const uint8_t marker = bytes[at + 1];
    if (marker == 0xFF || marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8)) {
      at += marker == 0xFF ? 1 : 2;  // fill bytes and markers without a segment
      continue;
    }
    const bool tables = marker == 0xC4 || marker == 0xC8 || marker == 0xCC;
    if (marker >= 0xC0 && marker <= 0xCF && !tables) {
      if (at + 9 > bytes.size()) return {};
      return {bigEndian(bytes, at + 7, 2), bigEndian(bytes, at + 5, 2)};
    }
    at += 2 + bigEndian(bytes, at + 2, 2);
  }
  return {};
}

}  // namespace

ImageFormat imageFormat(Bytes bytes) {
  if (begins(bytes, 0, "\x89PNG\r\n\x1a\n")) return ImageFormat::Png;
  if (begins(bytes, 0, "\xFF\xD8\xFF")) return ImageFormat::Jpeg;
  if (begins(bytes, 0, "RIFF") && begins(bytes, 8, "WEBP")) return ImageFormat::WebP;
  return ImageFormat::Unknown;
}

const char* mediaType(ImageFormat format) {
  constexpr const char* kTypes[] = {"image/png", "image/jpeg", "image/webp", ""};
  return kTypes[size_t(format)];
}

ImageSize imageSize(Bytes bytes) {
  switch (imageFormat(bytes)) {
    case ImageFormat::Png:
      if (bytes.size() < 24 || !begins(bytes, 12, "IHDR")) return {};
      return {bigEndian(bytes, 16, 4), bigEndian(bytes, 20, 4)};
    case ImageFormat::Jpeg:
      return jpegSize(bytes);
    case ImageFormat::WebP: {
      int width = 0, height = 0;
      if (!WebPGetInfo(bytes.data(), bytes.size(), &width, &height)) return {};
      return {uint32_t(width), uint32_t(height)};
    }
    default:
      return {};
  }
}

}  // namespace sb
