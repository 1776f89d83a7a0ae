// A glTF or GLB file taken apart: its JSON, checked; its buffers and images as bytes. Everything
// that could hang, abort or eat memory further down is stopped here, before tinygltf sees the file:
// its file access throws through the caller on a uri like "%00" (issue 416), so it gets none.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace sb {

/// Limits on what a file may ask for. Larger ones are refused with an InputError.
constexpr size_t kMaxJsonBytes = size_t(256) << 20;
constexpr size_t kMaxFileBytes = (size_t(2) << 30) - 1;
constexpr size_t kMaxJsonDepth = 100;
constexpr size_t kMaxVertices = size_t(1) << 25;   ///< of all meshes together
constexpr size_t kMaxTriangles = size_t(1) << 25;  ///< of all meshes together
constexpr size_t kMaxInstances = size_t(1) << 20;
constexpr size_t kMaxImagePixels = size_t(1) << 28;  ///< of all images together
constexpr size_t kMaxJsonContainers = size_t(1) << 22;  ///< objects and arrays
constexpr size_t kMaxWarnings = 100;                    ///< further ones are counted
constexpr size_t kMaxErrorBytes = 290;                  ///< of an error's line, path included
/// Memory that a file may make the scene take: so much whatever its size, and so many bytes for each
/// of its own. Data that are not in the file (accessors without a view, pictures of one colour,
/// instances, copies) are what this bounds.
constexpr size_t kFreeBytes = size_t(256) << 20;
constexpr size_t kBytesPerByte = 128;

/// What the user chose about a file (see SceneEdit "file" and "camera").
struct GltfOptions {
  std::string scene;          ///< name or index of the glTF scene; "": the file's default
  bool allowOutside = false;  ///< uris may name files outside the glTF file's folder
  /// Name or index of the animation that plays; nothing: the first one is shown at t = 0.
  std::optional<std::string> animation;
  uint32_t steps = 8;  ///< frames in which it plays, two at least
};

struct GltfSource {
  std::filesystem::path path;
  GltfOptions options;
  nlohmann::json json;
  std::vector<uint8_t> binChunk;  ///< of a GLB
  bool hasBinChunk = false;
  std::vector<std::vector<uint8_t>> buffers;  ///< each exactly `byteLength` long
  std::vector<std::string> warnings;
  std::set<std::string> warned;  ///< the same, to find them
  size_t unsaid = 0;             ///< warnings beyond kMaxWarnings
  size_t fileBytes = 0;          ///< of the file and of those that it names, read so far
  size_t namedBytes = 0;         ///< of files that uris name, read so far
  size_t takenBytes = 0;         ///< of memory, see take()

  /// An array at the root; an empty one where the file has none.
  const nlohmann::json& list(const char* key) const;
  /// Throws InputError "path: field: what", printable and at most kMaxErrorBytes long.
  [[noreturn]] void fail(const std::string& field, const std::string& what) const;
  /// Notes `what` for people, once.
  void warn(const std::string& what);
  /// Counts memory that `field` is about to take, as `count` times `each` bytes; fails when the file
  /// would take more than one of its size may.
  void take(const std::string& field, size_t count, size_t each);
};

/// Reads container and JSON of a .gltf or .glb file (told apart by content). Throws InputError.
GltfSource readGltfSource(const std::filesystem::path& path, const GltfOptions& options);
/// Fills `buffers` from data uris, files and the GLB chunk. After checkGltf().
void loadBuffers(GltfSource& source);
/// Bytes behind a uri: base64 data or a file beside the glTF file. `field` names it in errors.
/// `mimeType` gets the media type of a data uri.
std::vector<uint8_t> readUri(GltfSource& source, const std::string& field, const std::string& uri,
                             std::string& mimeType);
/// The file that a uri (no data uri) names, which may not exist.
std::filesystem::path uriPath(const GltfSource& source, const std::string& field,
                              const std::string& uri);
/// A JSON value as it stands in error texts: shortened.
std::string shown(const nlohmann::json& value);

}  // namespace sb
