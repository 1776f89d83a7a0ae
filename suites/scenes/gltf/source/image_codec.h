// PNG, JPEG and WebP in, PNG out, as 8-bit RGBA.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "techniques/scene/scene.h"

namespace sb {

enum class ImageFormat : uint8_t { Png, Jpeg, WebP, Unknown };
/// Told by the first bytes.
ImageFormat imageFormat(std::span<const uint8_t> bytes);
/// "image/png" ...; "" of what is unknown.
const char* mediaType(ImageFormat format);

struct ImageSize {
  uint32_t width = 0, height = 0;  ///< 0: the header cannot be read
};
/// As the header states it; nothing is decoded.
ImageSize imageSize(std::span<const uint8_t> bytes);
constexpr uint32_t kMaxImageSide = 16384;

/// Decodes PNG, JPEG or WebP. The size in the header is checked against `maxPixels` before anything
/// is allocated, and the decoder gets no more memory than a picture of that size needs, whatever
/// its data unpack to. On failure the image is empty and `error` says why.
Image decodeImage(std::span<const uint8_t> bytes, size_t maxPixels, std::string& error);
/// The image as PNG, exactly.
std::vector<uint8_t> encodePng(const Image& image);

}  // namespace sb
