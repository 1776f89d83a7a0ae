// Accessors as arrays: any component type, strided, normalized, sparse. checkGltf() has made sure
// that everything lies within its buffer; reads go through memcpy, for offsets may be unaligned.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "suites/scenes/gltf/check/check.h"
#include "suites/scenes/gltf/context.h"

namespace sb {
namespace {

template <typename T>
T load(const uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

size_t typeBytes(int componentType) { return elementBytes(componentType, "SCALAR"); }

float toFloat(const uint8_t* bytes, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const float v = load<int8_t>(bytes);
      return normalized ? std::max(v / 127.0f, -1.0f) : v;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return normalized ? float(*bytes) / 255.0f : float(*bytes);
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const float v = load<int16_t>(bytes);
      return normalized ? std::max(v / 32767.0f, -1.0f) : v;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
      const float v = load<uint16_t>(bytes);
      return normalized ? v / 65535.0f : v;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return float(load<uint32_t>(bytes));
    default:
      return load<float>(bytes);
  }
}

uint32_t toIndex(const uint8_t* bytes, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *bytes;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<uint16_t>(bytes);
    default:
      return load<uint32_t>(bytes);
  }
}

const uint8_t* viewData(const GltfContext& context, int view) {
  const tinygltf::BufferView& v = context.model.bufferViews[size_t(view)];
  return context.source.buffers[size_t(v.buffer)].data() + v.byteOffset;
}

// Calls `visit(element number, pointer to its first component)`: base elements first, then sparse
// ones over them.
template <typename Visit>
void forEachElement(const GltfContext& context, const std::string& field,
                    const tinygltf::Accessor& accessor, int components, size_t first, size_t end,
                    const Visit& visit) {
  const size_t bytes = typeBytes(accessor.componentType) * size_t(components);
  if (accessor.bufferView >= 0) {
    const size_t stated = context.model.bufferViews[size_t(accessor.bufferView)].byteStride;
    const size_t stride = stated ? stated : bytes;
    const uint8_t* data = viewData(context, accessor.bufferView) + accessor.byteOffset;
    for (size_t i = first; i < end; ++i) visit(i, data + i * stride);
  }
  if (!accessor.sparse.isSparse) return;
  const auto& sparse = accessor.sparse;
  const uint8_t* indices = viewData(context, sparse.indices.bufferView) + sparse.indices.byteOffset;
  const uint8_t* values = viewData(context, sparse.values.bufferView) + sparse.values.byteOffset;
  const size_t width = typeBytes(sparse.indices.componentType);
  for (size_t i = 0; i < size_t(sparse.count); ++i) {
    const uint32_t index = toIndex(indices + i * width, sparse.indices.componentType);
    if (index >= accessor.count)
      context.fail(field, "sparse index " + std::to_string(i) + " is " + std::to_string(index) +
                              ", expected less than " + std::to_string(accessor.count));
    if (index >= first && index < end) visit(index, values + i * bytes);
  }
}

// Zeros that no view holds cost nothing in the file.
void countZeros(const GltfContext& context, const std::string& field, int index, size_t count,
                size_t bytes) {
  if (context.model.accessors[size_t(index)].bufferView < 0)
    context.source.take(field + " (" + fieldAt("accessors", size_t(index)) + ")", count, bytes);
}

void requireFinite(const GltfContext& context, const std::string& field, int index, size_t first,
                   int components, const std::vector<float>& values) {
  for (size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    const size_t element = i / size_t(components);
    std::string text;
    for (size_t c = element * size_t(components); c < (element + 1) * size_t(components); ++c)
      text += (text.empty() ? "" : ", ") + std::to_string(values[c]);
    context.fail(field, fieldAt("accessors", size_t(index)) + " element " +
                            std::to_string(first + element) + " is (" + text +
                            "), expected finite numbers");
  }
}

}  // namespace

int componentCount(const GltfContext& context, const std::string& field, int index) {
  const int type = context.model.accessors[size_t(index)].type;
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    default:
      context.fail(field, "is a matrix accessor, expected a scalar or a vector");
  }
}

std::vector<float> readFloats(const GltfContext& context, const std::string& field, int index,
                              int components, size_t first, size_t count) {
  const tinygltf::Accessor& accessor = context.model.accessors[size_t(index)];
  first = std::min(first, accessor.count);
  const size_t end = first + std::min(count, accessor.count - first);
  countZeros(context, field, index, end - first, size_t(4) * size_t(components));
  std::vector<float> values((end - first) * size_t(components));
  const size_t bytes = typeBytes(accessor.componentType);
  const bool normalized = accessor.normalized && bytes < 4;
  forEachElement(context, field, accessor, components, first, end,
                 [&](size_t i, const uint8_t* data) {
                   float* out = values.data() + (i - first) * size_t(components);
                   for (int c = 0; c < components; ++c)
                     out[c] =
                         toFloat(data + size_t(c) * bytes, accessor.componentType, normalized);
                 });
  requireFinite(context, field, index, first, components, values);
  return values;
}

std::vector<uint32_t> readIndices(const GltfContext& context, const std::string& field, int index) {
  const tinygltf::Accessor& accessor = context.model.accessors[size_t(index)];
  const int type = accessor.componentType;
  if (accessor.type != TINYGLTF_TYPE_SCALAR || (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
                                                type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
                                                type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT))
    context.fail(field, "is accessors[" + std::to_string(index) + "] with componentType " +
                            std::to_string(type) +
                            ", expected a SCALAR of 5121, 5123 or 5125 (unsigned integers)");
  countZeros(context, field, index, accessor.count, 4);
  std::vector<uint32_t> values(accessor.count);
  forEachElement(context, field, accessor, 1, 0, accessor.count,
                 [&](size_t i, const uint8_t* data) { values[i] = toIndex(data, type); });
  return values;
}

}  // namespace sb
