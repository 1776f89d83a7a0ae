// PNG and JPEG in, PNG out, as 8-bit RGBA.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "techniques/common/scene.h"

namespace sb {

enum class ImageFormat : uint8_t { Png, Jpeg, Unknown };
/// Told by the first bytes.
ImageFormat imageFormat(std::span<const uint8_t> bytes);

/// Decodes PNG or JPEG. The size in the header is checked against `maxPixels` before anything is
/// allocated. On failure the image is empty and `error` says why.
Image decodeImage(std::span<const uint8_t> bytes, size_t maxPixels, std::string& error);
/// The image as PNG, exactly.
std::vector<uint8_t> encodePng(const Image& image);

}  // namespace sb
