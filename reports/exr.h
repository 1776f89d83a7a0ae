// OpenEXR files: 32-bit floats, one or many layers of four channels in one file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace report {

/// The channels NAME.R, NAME.G, NAME.B and NAME.A of a file; without a name R, G, B and A.
struct ExrLayer {
  std::string name;
  std::span<const float> rgba;  ///< width * height * 4, linear, row 0 at the bottom
};

/// Layers of one size in one file, row 0 at the top, channels in the order that the format asks for
/// (by name). Layers have different names. Throws std::runtime_error that names the path.
void writeExr(const std::filesystem::path& path, uint32_t width, uint32_t height,
              std::span<const ExrLayer> layers);

/// Bytes of memory that a layer takes for each pixel while it is written: its channels apart, and
/// what does not compress twice.
inline constexpr uint64_t kExrWritingBytes = 3 * 16;

}  // namespace report
