// A glTF or GLB file taken apart: its JSON, checked; its buffers and images as bytes. Everything
// that could hang, abort or eat memory further down is stopped here, before tinygltf sees the file:
// its file access throws through the caller on a uri like "%00" (issue 416), so it gets none.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace sb {

/// Limits on what a file may ask for. Larger ones are refused with an InputError.
constexpr size_t kMaxJsonBytes = size_t(64) << 20;
constexpr size_t kMaxFileBytes = (size_t(2) << 30) - 1;
constexpr size_t kMaxJsonDepth = 100;
constexpr size_t kMaxVertices = size_t(1) << 25;   ///< of all meshes together
constexpr size_t kMaxTriangles = size_t(1) << 25;  ///< of all meshes together
constexpr size_t kMaxInstances = size_t(1) << 20;
constexpr size_t kMaxImagePixels = size_t(1) << 28;  ///< of all images together

struct GltfSource {
  std::filesystem::path path;
  nlohmann::json json;
  std::vector<uint8_t> binChunk;  ///< of a GLB
  bool hasBinChunk = false;
  std::vector<std::vector<uint8_t>> buffers;  ///< each exactly `byteLength` long
  std::vector<std::string> warnings;

  /// Throws InputError "path: field: what".
  [[noreturn]] void fail(const std::string& field, const std::string& what) const;
  /// Notes `what` for people, once.
  void warn(const std::string& what);
};

/// Reads container and JSON of a .gltf or .glb file (told apart by content). Throws InputError.
GltfSource readGltfSource(const std::filesystem::path& path);
/// Fills `buffers` from data uris, files and the GLB chunk. After checkGltf().
void loadBuffers(GltfSource& source);
/// Bytes behind a uri: base64 data or a file beside the glTF file. `field` names it in errors.
/// `mimeType` gets the media type of a data uri.
std::vector<uint8_t> readUri(const GltfSource& source, const std::string& field,
                             const std::string& uri, std::string& mimeType);
/// The file that a uri (no data uri) names, which may not exist.
std::filesystem::path uriPath(const GltfSource& source, const std::string& field,
                              const std::string& uri);
/// A JSON value as it stands in error texts: shortened.
std::string shown(const nlohmann::json& value);

}  // namespace sb
