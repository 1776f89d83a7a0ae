// Checks that relate one part of a glTF file to another: sizes, versions, extensions, trees.
#include <set>

#include "suites/scenes/gltf/check/check.h"

namespace sb {
namespace {

using nlohmann::json;

const json kEmptyArray = json::array();

std::string at(const char* key, size_t i) {
  return std::string(key).append("[").append(std::to_string(i)).append("]");
}

// That a view, or the compressed bytes behind one, lie within their buffer.
void checkWithin(const GltfSource& source, const std::string& field, const json& view) {
  const size_t offset = view.value("byteOffset", size_t(0));
  const size_t length = view["byteLength"].get<size_t>();
  const size_t buffer = view["buffer"].get<size_t>();
  const size_t size = source.list("buffers")[buffer]["byteLength"].get<size_t>();
  if (offset > size || length > size - offset)
    source.fail(field + ".byteLength",
                "is " + std::to_string(length) + " from offset " + std::to_string(offset) +
                    ", but buffers[" + std::to_string(buffer) + "] has " + std::to_string(size) +
                    " bytes");
}

void checkViews(const GltfSource& source) {
  const json& views = source.list("bufferViews");
  for (size_t i = 0; i < views.size(); ++i) {
    checkWithin(source, at("bufferViews", i), views[i]);
    const std::string extension = "EXT_meshopt_compression";
    if (views[i].contains("extensions") && views[i]["extensions"].contains(extension))
      checkWithin(source, at("bufferViews", i) + ".extensions." + extension,
                  views[i]["extensions"][extension]);
  }
}

// That `count` elements of `bytes` each fit into a buffer view.
void checkFits(const GltfSource& source, const std::string& field, size_t view, size_t offset,
               size_t count, size_t bytes, bool strided) {
  const json& v = source.list("bufferViews")[view];
  size_t stride = bytes;
  if (strided && v.contains("byteStride")) stride = v["byteStride"].get<size_t>();
  if (stride < bytes)
    source.fail(at("bufferViews", view) + ".byteStride",
                "is " + std::to_string(stride) + ", but an element of " + field + " has " +
                    std::to_string(bytes) + " bytes");
  const size_t size = v["byteLength"].get<size_t>();
  const size_t needed = offset + stride * (count - 1) + bytes;
  if (needed > size)
    source.fail(field, "needs " + std::to_string(needed) + " bytes (count " +
                           std::to_string(count) + ", byteOffset " + std::to_string(offset) +
                           "), but bufferViews[" + std::to_string(view) + "] has " +
                           std::to_string(size));
}

void checkSparse(const GltfSource& source, const json& accessor, const std::string& field,
                 size_t bytes) {
  const json& sparse = accessor["sparse"];
  const size_t count = sparse["count"].get<size_t>();
  if (count > accessor["count"].get<size_t>())
    source.fail(field + ".sparse.count", "is " + std::to_string(count) +
                                             ", more than the accessor's count of " +
                                             shown(accessor["count"]));
  const json &indices = sparse["indices"], &values = sparse["values"];
  const int type = indices["componentType"];
  const size_t width = type == 5121 ? 1 : type == 5123 ? 2 : type == 5125 ? 4 : 0;
  if (width == 0)
    source.fail(field + ".sparse.indices.componentType",
                "is " + std::to_string(type) + ", expected 5121, 5123 or 5125");
  checkFits(source, field + ".sparse.indices", indices["bufferView"],
            indices.value("byteOffset", size_t(0)), count, width, false);
  checkFits(source, field + ".sparse.values", values["bufferView"],
            values.value("byteOffset", size_t(0)), count, bytes, false);
}

void checkAccessors(GltfSource& source) {
  const json& accessors = source.list("accessors");
  for (size_t i = 0; i < accessors.size(); ++i) {
    const json& accessor = accessors[i];
    const std::string field = at("accessors", i);
    const size_t bytes = elementBytes(accessor["componentType"], accessor["type"]);
    if (bytes == 0)
      source.fail(field, "has componentType " + shown(accessor["componentType"]) + " and type " +
                             shown(accessor["type"]) +
                             ", expected 5120-5123, 5125 or 5126 and SCALAR, VEC2, ... MAT4");
    const size_t count = accessor["count"].get<size_t>();
    const size_t offset = accessor.value("byteOffset", size_t(0));
    if (accessor.contains("bufferView"))
      checkFits(source, field, accessor["bufferView"], offset, count, bytes, true);
    // How much memory zeros may take is counted where they are read (GltfSource::take).
    else if (count > kMaxVertices)
      source.fail(field + ".count", "is " + std::to_string(count) +
                                        " without a bufferView, at most " +
                                        std::to_string(kMaxVertices) + " are read");
    if (accessor.contains("sparse")) checkSparse(source, accessor, field, bytes);
    if (accessor.value("normalized", false) && accessor["componentType"].get<int>() >= 5125)
      source.warn(field + ".normalized is set on 32-bit components and ignored");
    if (offset % 4 != 0 && accessor["componentType"].get<int>() >= 5125)
      source.warn(field + ".byteOffset is not a multiple of 4");
  }
}

// Every node has one parent at most and none is its own ancestor.
void checkNodes(GltfSource& source) {
  const json& nodes = source.list("nodes");
  constexpr size_t kNoParent = size_t(-1);
  std::vector<size_t> parent(nodes.size(), kNoParent);
  for (size_t i = 0; i < nodes.size(); ++i) {
    const json& children = nodes[i].value("children", kEmptyArray);
    for (size_t c = 0; c < children.size(); ++c) {
      const size_t child = children[c].get<size_t>();
      const std::string field = at("nodes", i) + "." + at("children", c);
      if (parent[child] != kNoParent)
        source.fail(field, "is " + std::to_string(child) + ", which nodes[" +
                               std::to_string(parent[child]) + "] already has as a child");
      parent[child] = i;
    }
  }
  std::vector<uint8_t> safe(nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i) {
    size_t steps = 0, n = i;
    for (; n != kNoParent && !safe[n]; n = parent[n])
      if (++steps > nodes.size()) source.fail(at("nodes", i), "is part of a loop of nodes");
    for (n = i; n != kNoParent && !safe[n]; n = parent[n]) safe[n] = 1;
  }
  const json& scenes = source.list("scenes");
  for (size_t s = 0; s < scenes.size(); ++s) {
    const json& roots = scenes[s].value("nodes", kEmptyArray);
    std::set<size_t> seen;
    for (size_t r = 0; r < roots.size(); ++r) {
      const std::string field = at("scenes", s) + "." + at("nodes", r);
      const size_t root = roots[r].get<size_t>();
      // readNodes() shows each node once, where its parents place it.
      if (parent[root] != kNoParent)
        source.warn(field + " is " + std::to_string(root) + ", which is a child of nodes[" +
                    std::to_string(parent[root]) + "]; it is shown once, under it");
      if (!seen.insert(root).second) source.warn(field + " names a node twice");
    }
  }
}

}  // namespace

size_t elementBytes(int componentType, const std::string& type) {
  const size_t bytes = componentType == 5120 || componentType == 5121   ? 1
                       : componentType == 5122 || componentType == 5123 ? 2
                       : componentType == 5125 || componentType == 5126 ? 4
                                                                        : 0;
  if (type == "SCALAR") return bytes;
  if (type == "VEC2") return 2 * bytes;
  if (type == "VEC3") return 3 * bytes;
  if (type == "VEC4") return 4 * bytes;
  const auto matrix = [&](size_t n) { return n * ((n * bytes + 3) / 4 * 4); };
  if (type == "MAT2") return matrix(2);
  if (type == "MAT3") return matrix(3);
  if (type == "MAT4") return matrix(4);
  return 0;
}

void checkLayout(GltfSource& source) {
  checkAsset(source);
  checkExtensions(source);
  checkViews(source);
  checkAccessors(source);
  checkNodes(source);
}

}  // namespace sb
