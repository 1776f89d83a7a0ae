// PNG files byte by byte, so that tests can lie in them. Checksums are left 0: the decoder does not
// look at them.
#pragma once

#include <zlib.h>

#include <string>

namespace sb::test {

inline std::string pngWord(uint32_t value) {
  return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}
inline std::string pngChunk(const std::string& type, const std::string& data) {
  return pngWord(uint32_t(data.size())) + type + data + pngWord(0);
}
/// Signature and header of 8-bit RGBA.
inline std::string pngHeader(uint32_t width, uint32_t height) {
  return std::string("\x89PNG\r\n\x1a\n") +
         pngChunk("IHDR", pngWord(width) + pngWord(height) + std::string("\x08\x06\0\0\0", 5));
}
inline std::string pngEnd() { return pngChunk("IEND", ""); }
/// A transparent black picture, with `more` zeros packed behind its pixels.
inline std::string pngBytes(uint32_t width, uint32_t height, size_t more = 0) {
  const std::string raw((size_t(4) * width + 1) * height + more, '\0');
  uLongf size = compressBound(uLong(raw.size()));
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(raw.data()), uLong(raw.size()));
  packed.resize(size);
  return pngHeader(width, height) + pngChunk("IDAT", packed) + pngEnd();
}

}  // namespace sb::test
