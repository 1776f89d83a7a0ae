// KHR_draco_mesh_compression: each primitive is unpacked into accessors of its own, with the types
// that the file's accessors state.
#include <draco/compression/decode.h>

#include <cstring>
#include <map>
#include <memory>

#include "suites/scenes/gltf/check/check.h"
#include "suites/scenes/gltf/source/compression.h"

namespace sb {
namespace {

using nlohmann::json;

using Bytes = std::span<const uint8_t>;

// Variable-length number of draco's bit stream.
bool readVarint(Bytes& bytes, uint64_t& value) {
  value = 0;
  for (int shift = 0; shift < 63; shift += 7) {
    if (bytes.empty()) return false;
    const uint8_t byte = bytes[0];
    bytes = bytes.subspan(1);
    value |= uint64_t(byte & 0x7F) << shift;
    if (!(byte & 0x80)) return true;
  }
  return false;
}

// Numbers that the stream's head states: the decoder takes memory for them before it has read what
// they count. Streams with metadata state them later and are left to the decoder.
void takeStated(GltfSource& source, const std::string& field, Bytes bytes) {
  if (bytes.size() < 12 || std::memcmp(bytes.data(), "DRACO", 5) != 0)
    source.fail(field, "does not begin with 'DRACO'");
  if (bytes[5] < 2 || bytes[6] < 2)
    source.fail(field, "has draco's bit stream " + std::to_string(bytes[5]) + "." +
                           std::to_string(bytes[6]) + ", expected 2.2");
  const bool edgebreaker = bytes[8] == 1;
  const bool metadata = (bytes[10] & 0x80) != 0;
  if (metadata) source.fail(field, "holds draco metadata, expected geometry alone");
  bytes = bytes.subspan(edgebreaker ? 12 : 11);
  uint64_t first = 0, second = 0;
  if (!readVarint(bytes, first) || !readVarint(bytes, second)) source.fail(field, "is cut off");
  source.take(field, size_t(first), 64);
  source.take(field, size_t(second), 64);
}

std::unique_ptr<draco::Mesh> decode(GltfSource& source, const std::string& field, Bytes bytes) {
  takeStated(source, field, bytes);
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto result = decoder.DecodeMeshFromBuffer(&buffer);
  if (!result.ok())
    source.fail(field, "cannot be unpacked: draco says " + result.status().error_msg_string());
  return std::move(result).value();
}

/// Appends a buffer, a view and an accessor with `bytes`; gives the accessor's index.
size_t appendAccessor(GltfSource& source, json accessor, std::vector<uint8_t> bytes) {
  source.json["bufferViews"].push_back(
      {{"buffer", source.buffers.size()}, {"byteLength", bytes.size()}});
  source.buffers.push_back(std::move(bytes));
  accessor["bufferView"] = source.json["bufferViews"].size() - 1;
  accessor.erase("byteOffset");
  accessor.erase("sparse");
  source.json["accessors"].push_back(std::move(accessor));
  return source.json["accessors"].size() - 1;
}

template <class T>
bool convert(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int components,
             std::vector<uint8_t>& out) {
  out.resize(size_t(mesh.num_points()) * size_t(components) * sizeof(T));
  auto* values = reinterpret_cast<T*>(out.data());
  for (draco::PointIndex i(0); i < mesh.num_points(); ++i)
    if (!attribute.ConvertValue<T>(attribute.mapped_index(i), int8_t(components),
                                   values + size_t(i.value()) * size_t(components)))
      return false;
  return true;
}

bool convert(const draco::Mesh& mesh, const draco::PointAttribute& attribute, int type,
             int components, std::vector<uint8_t>& out) {
  switch (type) {
    case 5120:
      return convert<int8_t>(mesh, attribute, components, out);
    case 5121:
      return convert<uint8_t>(mesh, attribute, components, out);
    case 5122:
      return convert<int16_t>(mesh, attribute, components, out);
    case 5123:
      return convert<uint16_t>(mesh, attribute, components, out);
    case 5125:
      return convert<uint32_t>(mesh, attribute, components, out);
    default:
      return convert<float>(mesh, attribute, components, out);
  }
}

void unpackAttribute(GltfSource& source, const std::string& field, const draco::Mesh& mesh,
                     uint32_t id, json& reference) {
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(id);
  if (!attribute)
    source.fail(field, "is " + std::to_string(id) + ", an attribute that the data do not hold");
  const json accessor = source.json["accessors"][reference.get<size_t>()];
  const int type = accessor["componentType"];
  const int components = int(elementBytes(5121, accessor["type"]));
  if (components > 4) source.fail(field, "is a matrix accessor, expected a scalar or a vector");
  if (accessor["count"].get<size_t>() != mesh.num_points())
    source.fail(field, "holds " + std::to_string(mesh.num_points()) + " elements, its accessor " +
                           shown(accessor["count"]));
  source.take(field, mesh.num_points(), 4 * size_t(components));
  std::vector<uint8_t> bytes;
  if (mesh.num_points() == 0 || !convert(mesh, *attribute, type, components, bytes))
    source.fail(field, "cannot be unpacked into its accessor's type");
  reference = appendAccessor(source, accessor, std::move(bytes));
}

void unpackIndices(GltfSource& source, const std::string& field, const draco::Mesh& mesh,
                   json& primitive) {
  source.take(field, mesh.num_faces(), 12);
  std::vector<uint8_t> bytes(size_t(mesh.num_faces()) * 12);
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
    for (size_t c = 0; c < 3; ++c) {
      const uint32_t corner = mesh.face(f)[c].value();
      std::memcpy(bytes.data() + 12 * size_t(f.value()) + 4 * c, &corner, 4);
    }
  if (bytes.empty()) source.fail(field, "holds no triangles");
  const size_t count = size_t(mesh.num_faces()) * 3;
  primitive["indices"] = appendAccessor(
      source, {{"componentType", 5125}, {"count", count}, {"type", "SCALAR"}}, std::move(bytes));
  primitive["mode"] = 4;
}

void unpackPrimitive(GltfSource& source, const std::string& field, json& primitive) {
  const std::string at = field + ".extensions.KHR_draco_mesh_compression";
  const json extension = primitive["extensions"]["KHR_draco_mesh_compression"];
  const json& view = source.json["bufferViews"][extension["bufferView"].get<size_t>()];
  const Bytes buffer = source.buffers[view["buffer"].get<size_t>()];
  const auto mesh =
      decode(source, at + ".bufferView",
             buffer.subspan(view.value("byteOffset", size_t(0)), view["byteLength"].get<size_t>()));
  for (const auto& [name, id] : extension["attributes"].items()) {
    const std::string attribute = at + ".attributes." + name;
    if (!id.is_number_unsigned() || id.get<uint64_t>() > 0xFFFFFFFFu)
      source.fail(attribute, "is " + shown(id) + ", expected a whole number >= 0");
    if (!primitive["attributes"].contains(name))
      source.fail(attribute, "is not among the primitive's attributes");
    unpackAttribute(source, attribute, *mesh, id.get<uint32_t>(), primitive["attributes"][name]);
  }
  unpackIndices(source, at, *mesh, primitive);
}

}  // namespace

void unpackPrimitives(GltfSource& source) {
  const auto meshes = source.json.find("meshes");
  for (size_t m = 0; meshes != source.json.end() && m < meshes->size(); ++m) {
    json& primitives = (*meshes)[m]["primitives"];
    for (size_t p = 0; p < primitives.size(); ++p) {
      json& primitive = primitives[p];
      if (!primitive.contains("extensions") ||
          !primitive["extensions"].contains("KHR_draco_mesh_compression"))
        continue;
      unpackPrimitive(source,
                      "meshes[" + std::to_string(m) + "].primitives[" + std::to_string(p) + "]",
                      primitive);
    }
  }
}

}  // namespace sb
