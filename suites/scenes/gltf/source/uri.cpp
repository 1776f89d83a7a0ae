// Bytes behind uris: base64 data or files beside the glTF file, never the network.
#include <array>
#include <optional>

#include "base/percent.h"
#include "suites/scenes/gltf/source/file_io.h"
#include "suites/scenes/gltf/source/source.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

using nlohmann::json;

std::optional<std::vector<uint8_t>> decodeBase64(std::string_view text) {
  static const auto kValues = [] {
    std::array<int8_t, 256> values;
    values.fill(-1);
    const std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < letters.size(); ++i) values[uint8_t(letters[i])] = int8_t(i);
    values['-'] = 62, values['_'] = 63;
    return values;
  }();
  for (int pad = 0; pad < 2 && text.ends_with('='); ++pad) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<uint8_t> bytes;
  bytes.reserve(text.size() * 3 / 4);
  uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int value = kValues[uint8_t(c)];
    if (value < 0) return std::nullopt;
    bits = bits << 6 | uint32_t(value);
    if ((count += 6) >= 8) bytes.push_back(uint8_t(bits >> (count -= 8)));
  }
  return bytes;
}

std::string percentDecoded(const GltfSource& source, const std::string& field,
                           const std::string& uri, bool zeroAllowed) {
  const auto text = base::percentDecoded(uri);
  if (!text)
    source.fail(field, shown(uri) + " is not a valid uri: '%' needs two hexadecimal digits");
  if (!zeroAllowed && text->find('\0') != std::string::npos)
    source.fail(field, shown(uri) + " is not a valid uri: it holds a zero byte");
  return *text;
}

// A file of others must not be able to name what it likes on this machine: neither by "..", encoded
// or not, nor by links. The glTF file itself may be a link: its folder is where the link leads, or
// where it stands.
void refuseOutside(const GltfSource& source, const std::string& field, const std::string& uri,
                   const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  if (error) source.fail(field, shown(uri) + " cannot be followed: " + error.message());
  const auto within = [&](const fs::path& folder) {
    const fs::path inside = target.lexically_relative(folder);
    return !inside.empty() && *inside.begin() != "..";
  };
  const fs::path parent = source.path.parent_path();
  if (within(fs::weakly_canonical(parent.empty() ? fs::path(".") : parent, error))) return;
  if (within(fs::weakly_canonical(source.path, error).parent_path())) return;
  source.fail(field, shown(uri) +
                         " lies outside the file's folder, expected a file within it "
                         "(--allow-outside reads it)");
}

}  // namespace

std::filesystem::path uriPath(const GltfSource& source, const std::string& field,
                              const std::string& uri) {
  if (uri.empty()) source.fail(field, "is empty, expected a file name or a data uri");
  const size_t colon = uri.find(':');
  if (colon != std::string::npos && uri.find('/') > colon)
    source.fail(field, shown(uri) + " is not a file: expected a relative path or a data uri");
  const std::filesystem::path named = percentDecoded(source, field, uri, false);
  const std::filesystem::path path = source.path.parent_path() / named;
  if (source.options.allowOutside) return path;
  if (named.is_absolute())
    source.fail(field, shown(uri) +
                           " is an absolute path, expected one within the file's folder "
                           "(--allow-outside reads it)");
  refuseOutside(source, field, uri, path);
  return path;
}

std::vector<uint8_t> readUri(GltfSource& source, const std::string& field, const std::string& uri,
                             std::string& mimeType) {
  mimeType.clear();
  if (uri.starts_with("data:")) {
    const size_t comma = uri.find(',');
    const std::string head = uri.substr(5, comma == std::string::npos ? 0 : comma - 5);
    if (comma == std::string::npos || head.find(";;") != head.npos)
      source.fail(field, shown(uri) + " is not a valid data uri: expected data:TYPE;base64,...");
    mimeType = head.substr(0, head.find(';'));
    if (!head.ends_with(";base64")) {
      const std::string text = percentDecoded(source, field, uri.substr(comma + 1), true);
      return {text.begin(), text.end()};
    }
    auto bytes = decodeBase64(std::string_view(uri).substr(comma + 1));
    if (!bytes) source.fail(field, shown(uri) + " holds invalid base64");
    return *std::move(bytes);
  }
  const std::filesystem::path path = uriPath(source, field, uri);
  try {
    // What is named a thousand times is read a thousand times: bounded in sum.
    const size_t left = kMaxFileBytes - std::min(kMaxFileBytes, source.namedBytes);
    std::vector<uint8_t> bytes = readWholeFile(path, left);
    source.namedBytes += bytes.size();
    source.fileBytes += bytes.size();
    return bytes;
  } catch (const InputError& error) {
    source.fail(field, error.what());
  }
}

namespace {

// Buffers whose bytes something reads. Compressed views read those of their extension; the buffer
// that they name themselves stands in for viewers without it.
std::vector<uint8_t> usedBuffers(const GltfSource& source, size_t count) {
  std::vector<uint8_t> used(count);
  const auto views = source.json.find("bufferViews");
  if (views == source.json.end()) return used;
  for (const json& view : *views) {
    const json* reads = &view;
    if (view.contains("extensions"))
      if (const auto found = view["extensions"].find("EXT_meshopt_compression");
          found != view["extensions"].end())
        reads = &*found;
    used[(*reads)["buffer"].get<size_t>()] = 1;
  }
  return used;
}

std::vector<uint8_t> bufferBytes(GltfSource& source, const std::string& field, const json& buffer) {
  std::string mimeType;
  std::vector<uint8_t> bytes = readUri(source, field + ".uri", buffer["uri"], mimeType);
  if (!mimeType.empty() && mimeType != "application/octet-stream" &&
      mimeType != "application/gltf-buffer")
    source.warn(field + ".uri: media type '" + mimeType +
                "', expected application/octet-stream; its bytes are used");
  return bytes;
}

}  // namespace

void loadBuffers(GltfSource& source) {
  const auto found = source.json.find("buffers");
  if (found == source.json.end()) return;
  source.buffers.resize(found->size());
  const std::vector<uint8_t> used = usedBuffers(source, found->size());
  size_t total = 0;
  for (size_t i = 0; i < found->size(); ++i) {
    const std::string field = "buffers[" + std::to_string(i) + "]";
    const json& buffer = (*found)[i];
    const size_t length = buffer["byteLength"].get<size_t>();
    std::vector<uint8_t>& bytes = source.buffers[i];
    if (buffer.contains("uri")) {
      bytes = bufferBytes(source, field, buffer);
    } else if (i == 0 && source.hasBinChunk) {
      bytes = source.binChunk;
    } else {
      if (used[i]) source.fail(field, "has neither a uri nor a GLB chunk that holds its data");
      source.warn(field + " has no data and is not used");
      continue;
    }
    if (bytes.size() < length)
      source.fail(field + ".byteLength", "is " + std::to_string(length) + ", but its data has " +
                                             std::to_string(bytes.size()) + " bytes");
    bytes.resize(length);
    if ((total += length) > kMaxFileBytes)
      source.fail("buffers", "hold more than " + std::to_string(kMaxFileBytes) + " bytes together");
  }
}

}  // namespace sb
