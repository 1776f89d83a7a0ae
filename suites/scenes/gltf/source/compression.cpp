// EXT_meshopt_compression: buffer views are unpacked into buffers of their own, and the JSON is
// made to point there, so that nothing behind this step knows of compression.
#include "suites/scenes/gltf/source/compression.h"

#include <meshoptimizer.h>

namespace sb {
namespace {

using nlohmann::json;

enum class Mode { Attributes, Triangles, Indices };
enum class Filter { None, Octahedral, Quaternion, Exponential };

struct Packed {
  Mode mode = Mode::Attributes;
  Filter filter = Filter::None;
  size_t count = 0, stride = 0;
  std::span<const uint8_t> bytes;
};

template <class T>
T oneOf(const GltfSource& source, const std::string& field, const std::string& found,
        std::initializer_list<std::pair<const char*, T>> known) {
  std::string names;
  for (const auto& [name, value] : known) {
    if (found == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  source.fail(field, "is " + shown(found) + ", expected one of " + names);
}

// The library asserts these rather than failing.
void checkStride(const GltfSource& source, const std::string& field, const Packed& p) {
  const auto require = [&](bool right, const char* expected) {
    if (!right)
      source.fail(field + ".byteStride",
                  "is " + std::to_string(p.stride) + ", expected " + expected);
  };
  if (p.mode == Mode::Attributes)
    require(p.stride % 4 == 0, "a multiple of 4 for ATTRIBUTES");
  else
    require(p.stride == 2 || p.stride == 4, "2 or 4 for indices");
  if (p.mode != Mode::Attributes && p.filter != Filter::None)
    source.fail(field + ".filter", "is set for indices, expected NONE");
  if (p.mode == Mode::Triangles && p.count % 3 != 0)
    source.fail(field + ".count", "is " + std::to_string(p.count) + ", expected a multiple of 3");
  if (p.filter == Filter::Octahedral)
    require(p.stride == 4 || p.stride == 8, "4 or 8 for OCTAHEDRAL");
  if (p.filter == Filter::Quaternion) require(p.stride == 8, "8 for QUATERNION");
}

Packed readPacked(const GltfSource& source, const std::string& field, const json& extension) {
  Packed p;
  p.mode = oneOf<Mode>(source, field + ".mode", extension["mode"],
                       {{"ATTRIBUTES", Mode::Attributes},
                        {"TRIANGLES", Mode::Triangles},
                        {"INDICES", Mode::Indices}});
  p.filter = oneOf<Filter>(source, field + ".filter", extension.value("filter", "NONE"),
                           {{"NONE", Filter::None},
                            {"OCTAHEDRAL", Filter::Octahedral},
                            {"QUATERNION", Filter::Quaternion},
                            {"EXPONENTIAL", Filter::Exponential}});
  p.count = extension["count"].get<size_t>();
  p.stride = extension["byteStride"].get<size_t>();
  const std::span<const uint8_t> buffer = source.buffers[extension["buffer"].get<size_t>()];
  p.bytes = buffer.subspan(extension.value("byteOffset", size_t(0)),
                           extension["byteLength"].get<size_t>());
  checkStride(source, field, p);
  return p;
}

bool unpack(const Packed& p, std::vector<uint8_t>& out) {
  const uint8_t* data = p.bytes.data();
  const size_t size = p.bytes.size();
  switch (p.mode) {
    case Mode::Attributes:
      if (meshopt_decodeVertexBuffer(out.data(), p.count, p.stride, data, size) != 0) return false;
      break;
    case Mode::Triangles:
      return meshopt_decodeIndexBuffer(out.data(), p.count, p.stride, data, size) == 0;
    case Mode::Indices:
      return meshopt_decodeIndexSequence(out.data(), p.count, p.stride, data, size) == 0;
  }
  if (p.filter == Filter::Octahedral) meshopt_decodeFilterOct(out.data(), p.count, p.stride);
  if (p.filter == Filter::Quaternion) meshopt_decodeFilterQuat(out.data(), p.count, p.stride);
  if (p.filter == Filter::Exponential) meshopt_decodeFilterExp(out.data(), p.count, p.stride);
  return true;
}

}  // namespace

void unpackBufferViews(GltfSource& source) {
  const auto views = source.json.find("bufferViews");
  if (views == source.json.end()) return;
  const std::string name = "EXT_meshopt_compression";
  for (size_t i = 0; i < views->size(); ++i) {
    json& view = (*views)[i];
    if (!view.contains("extensions") || !view["extensions"].contains(name)) continue;
    const std::string field = "bufferViews[" + std::to_string(i) + "].extensions." + name;
    const Packed packed = readPacked(source, field, view["extensions"][name]);
    const size_t length = packed.count * packed.stride;
    if (length < view["byteLength"].get<size_t>())
      source.fail(field + ".count", "gives " + std::to_string(length) + " bytes, the view has " +
                                        shown(view["byteLength"]));
    source.take(field, packed.count, packed.stride);
    std::vector<uint8_t> bytes(length);
    if (!unpack(packed, bytes)) source.fail(field, "cannot be unpacked, expected meshopt data");
    view["buffer"] = source.buffers.size();
    view["byteOffset"] = 0;
    source.buffers.push_back(std::move(bytes));
  }
}

}  // namespace sb
