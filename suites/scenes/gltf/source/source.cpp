// The GLB container, the JSON text and the limits on both.
#include "suites/scenes/gltf/source/source.h"

#include <algorithm>
#include <cstring>

#include "base/text.h"
#include "suites/scenes/gltf/source/file_io.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

using nlohmann::json;

constexpr uint32_t kGlbMagic = 0x46546C67;
constexpr uint32_t kChunkJson = 0x4E4F534A;
constexpr uint32_t kChunkBin = 0x004E4942;

uint32_t wordAt(std::span<const uint8_t> bytes, size_t offset) {
  uint32_t word;
  std::memcpy(&word, bytes.data() + offset, 4);
  return word;
}

// Splits a GLB into its JSON text (returned) and its BIN chunk.
std::span<const uint8_t> readContainer(GltfSource& source, std::span<const uint8_t> bytes) {
  if (bytes.size() < 12)
    source.fail("GLB header", "the file ends after " + std::to_string(bytes.size()) +
                                  " bytes, expected a header of 12");
  const uint32_t version = wordAt(bytes, 4), length = wordAt(bytes, 8);
  if (version != 2)
    source.fail("GLB header", "version is " + std::to_string(version) + ", expected 2" +
                                  (version == 1 ? " (this is a binary glTF 1.0)" : ""));
  if (length > bytes.size() || length < 20)
    source.fail("GLB header", "length is " + std::to_string(length) + ", the file has " +
                                  std::to_string(bytes.size()) + " bytes");
  if (length < bytes.size())
    source.warn(std::to_string(bytes.size() - length) + " bytes after the end of the GLB ignored");
  bytes = bytes.first(length);

  std::span<const uint8_t> text;
  size_t offset = 12;
  for (size_t chunk = 0; offset < bytes.size(); ++chunk) {
    const std::string field = "GLB chunk " + std::to_string(chunk);
    if (bytes.size() - offset < 8) source.fail(field, "its header is cut off");
    const size_t size = wordAt(bytes, offset);
    const uint32_t type = wordAt(bytes, offset + 4);
    offset += 8;
    if (size > bytes.size() - offset)
      source.fail(field, "length is " + std::to_string(size) + ", only " +
                             std::to_string(bytes.size() - offset) + " bytes are left");
    if (size % 4 != 0)
      source.fail(field, "length " + std::to_string(size) + " is not a multiple of 4");
    const auto data = bytes.subspan(offset, size);
    offset += size;
    if (chunk == 0) {
      if (type != kChunkJson) source.fail(field, "is not of type JSON, which must come first");
      if (size == 0) source.fail(field, "is empty, expected JSON text");
      text = data;
    } else if (type == kChunkJson) {
      source.fail(field, "is a second JSON chunk, expected one");
    } else if (type == kChunkBin) {
      if (source.hasBinChunk) source.fail(field, "is a second BIN chunk, expected one");
      if (chunk != 1) source.fail(field, "is the BIN chunk, which must be the second");
      source.binChunk.assign(data.begin(), data.end());
      source.hasBinChunk = true;
    } else {
      source.warn(field + " is of an unknown type and ignored");
    }
  }
  return text;
}

// Walks the text without building values, so that depth and number are known before anything nests
// or takes memory.
struct DepthCounter : nlohmann::json_sax<json> {
  size_t depth = 0, deepest = 0, containers = 0;
  std::string error;
  bool enter() {
    deepest = std::max(deepest, ++depth);
    return deepest <= kMaxJsonDepth && ++containers <= kMaxJsonContainers;
  }
  bool leave() { return --depth, true; }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(size_t) override { return enter(); }
  bool key(string_t&) override { return true; }
  bool end_object() override { return leave(); }
  bool start_array(size_t) override { return enter(); }
  bool end_array() override { return leave(); }
  bool parse_error(size_t, const std::string&, const nlohmann::detail::exception& e) override {
    error = e.what();
    return false;
  }
};

json parseJson(GltfSource& source, std::span<const uint8_t> text) {
  if (text.size() > kMaxJsonBytes)
    source.fail("JSON", "has " + std::to_string(text.size()) + " bytes, at most " +
                            std::to_string(kMaxJsonBytes) + " are read");
  if (text.size() >= 3 && text[0] == 0xEF && text[1] == 0xBB && text[2] == 0xBF) {
    source.warn("a byte order mark before the JSON text is ignored");
    text = text.subspan(3);
  }
  DepthCounter counter;
  if (!json::sax_parse(text.begin(), text.end(), &counter)) {
    if (counter.containers > kMaxJsonContainers)
      source.fail("JSON", "holds more than the " + std::to_string(kMaxJsonContainers) +
                              " objects and arrays that are read");
    if (counter.error.empty())
      source.fail("JSON", "is nested deeper than " + std::to_string(kMaxJsonDepth) + " levels");
    source.fail("JSON", counter.error);
  }
  json value = json::parse(text.begin(), text.end());
  if (!value.is_object()) source.fail("JSON", "is " + shown(value) + ", expected an object");
  return value;
}

}  // namespace

const nlohmann::json& GltfSource::list(const char* key) const {
  static const nlohmann::json kEmpty = nlohmann::json::array();
  const auto found = json.find(key);
  return found == json.end() ? kEmpty : *found;
}

void GltfSource::fail(const std::string& field, const std::string& what) const {
  // Each part keeps its share: a path or a name of a thousand letters must not hide the reason.
  const std::string where = base::shortened(base::printable(path.string()), 120) + ": " +
                            base::shortened(base::printable(field), 100);
  throw InputError(where,
                   base::shortened(base::printable(what), kMaxErrorBytes - where.size() - 2));
}

void GltfSource::warn(const std::string& what) {
  const std::string text = base::shortened(base::printable(what), kMaxErrorBytes);
  if (warned.contains(text)) return;
  if (warnings.size() >= kMaxWarnings) {
    ++unsaid;
    return;
  }
  warned.insert(text);
  warnings.push_back(text);
}

void GltfSource::take(const std::string& field, size_t count, size_t each) {
  const size_t most = kFreeBytes + kBytesPerByte * fileBytes;
  const size_t left = most - std::min(most, takenBytes);
  if (each > 0 && count > left / each)
    fail(field, "takes the scene beyond the " + std::to_string(most >> 20) +
                    " MiB of memory that a file of " + std::to_string(fileBytes) +
                    " bytes may ask for (count " + std::to_string(count) + ")");
  takenBytes += count * each;
}

std::string shown(const json& value) {
  // Long strings may hold megabytes of base64; bytes that are no UTF-8 must not throw here.
  std::string text =
      value.is_array() && value.size() > 16   ? "an array of " + std::to_string(value.size())
      : value.is_object() && value.size() > 4 ? "an object"
      : value.is_string() && value.get_ref<const std::string&>().size() > 60
          ? "\"" +
                base::shortened(
                    base::printable(base::shortened(value.get_ref<const std::string&>(), 240)),
                    60) +
                "\""
          : value.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > 80) text = text.substr(0, 77) + "...";
  return text;
}

GltfSource readGltfSource(const std::filesystem::path& path, const GltfOptions& options) {
  GltfSource source;
  source.path = path;
  source.options = options;
  const std::vector<uint8_t> bytes = readWholeFile(path, kMaxFileBytes);
  source.fileBytes = bytes.size();
  if (bytes.empty()) throw InputError(path.string(), "is empty, expected glTF");
  const bool binary = bytes.size() >= 4 && wordAt(bytes, 0) == kGlbMagic;
  std::span<const uint8_t> text = bytes;
  if (binary)
    text = readContainer(source, bytes);
  else if (path.extension() == ".glb")
    source.fail("GLB header", "does not begin with 'glTF'");
  source.json = parseJson(source, text);
  return source;
}

}  // namespace sb
