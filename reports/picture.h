// Pictures as files: linear RGBA floats (row 0 = bottom row) to PNG for looking at and to OpenEXR
// for computing with.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace report {

struct Picture {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<float> rgba;  ///< width * height * 4, linear, row 0 at the bottom
};

/// 8-bit sRGB encoding of [0,1], row 0 at the top, 3 bytes a pixel. `exposure` multiplies first.
std::vector<uint8_t> toSrgb8(const Picture& picture, float exposure = 1);
/// PNG bytes of 8-bit RGB, row 0 at the top.
std::string encodePng(uint32_t width, uint32_t height, std::span<const uint8_t> rgb);
void writePng(const std::filesystem::path& path, const Picture& picture, float exposure = 1);
/// 32-bit float RGBA OpenEXR, linear, row 0 at the top. Throws std::runtime_error.
void writeExr(const std::filesystem::path& path, const Picture& picture);

/// 64-bit FNV-1a of bytes as 16 hex digits: names pictures and scenes by content.
std::string contentHash(std::span<const std::byte> bytes);

}  // namespace report
