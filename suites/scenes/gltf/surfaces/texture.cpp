// Images and the slots that use them.
#include <cfloat>
#include <cmath>

#include "suites/scenes/gltf/context.h"
#include "suites/scenes/gltf/source/image_codec.h"

namespace sb {
namespace {

using nlohmann::json;

Wrap readWrap(const GltfContext& context, const std::string& field, int mode) {
  switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT:
      return Wrap::Repeat;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
      return Wrap::MirroredRepeat;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
      return Wrap::ClampToEdge;
    default:
      context.fail(field, "is " + std::to_string(mode) + ", expected 10497, 33648 or 33071");
  }
}

// Rows of offset * rotation * scale. glTF turns counter-clockwise as seen on the picture, whose v
// runs down: hence the signs (the extension's example: 90 degrees and offset (0,1) stay inside).
std::array<glm::vec3, 2> transformRows(const tinygltf::Value& transform) {
  const auto number = [&](const char* key, size_t i, double fallback) {
    return transform.Has(key) ? transform.Get(key).Get(i).GetNumberAsDouble() : fallback;
  };
  const double turn =
      transform.Has("rotation") ? transform.Get("rotation").GetNumberAsDouble() : 0.0;
  const double sx = number("scale", 0, 1), sy = number("scale", 1, 1);
  const double c = std::cos(turn), s = std::sin(turn);
  return {glm::vec3(float(c * sx), float(s * sy), float(number("offset", 0, 0))),
          glm::vec3(float(-s * sx), float(c * sy), float(number("offset", 1, 0)))};
}

// A file that is not there, like a format that is not read, costs the texture, not the scene.
bool fileMissing(const GltfContext& context, const std::string& field, const json& image) {
  if (!image.contains("uri") || image["uri"].get_ref<const std::string&>().starts_with("data:"))
    return false;
  std::error_code ignored;
  return !std::filesystem::exists(uriPath(context.source, field + ".uri", image["uri"]), ignored);
}

// Bytes of an image; `owned` keeps those that lie in no buffer.
std::span<const uint8_t> imageBytes(GltfContext& context, const std::string& field,
                                    const json& image, std::string& mimeType,
                                    std::vector<uint8_t>& owned) {
  if (image.contains("uri") == image.contains("bufferView"))
    context.fail(field, "needs either a uri or a bufferView");
  if (image.contains("uri"))
    return owned = readUri(context.source, field + ".uri", image["uri"], mimeType);
  const size_t index = image["bufferView"].get<size_t>();
  const tinygltf::BufferView& view = context.model.bufferViews[index];
  if (view.byteStride != 0)
    context.warn(fieldAt("bufferViews", index) + ".byteStride is set for an image and ignored");
  if (!image.contains("mimeType")) context.warn(field + ".mimeType is missing");
  const std::span<const uint8_t> buffer = context.source.buffers[size_t(view.buffer)];
  return buffer.subspan(view.byteOffset, view.byteLength);
}

void checkMimeType(GltfContext& context, const std::string& field, const std::string& stated,
                   ImageFormat format) {
  if (!stated.empty() && stated != mediaType(format))
    context.warn(field + " states type '" + stated + "' but is " + mediaType(format));
}

Image readImage(GltfContext& context, const std::string& field, const json& source,
                std::string& mimeType) {
  std::vector<uint8_t> owned;
  const std::span<const uint8_t> bytes = imageBytes(context, field, source, mimeType, owned);
  const ImageFormat format = imageFormat(bytes);
  if (format == ImageFormat::Unknown) {
    context.warn(field + " is neither PNG, JPEG nor WebP and was not read");
    return {};
  }
  const ImageSize size = imageSize(bytes);
  std::string error;
  if (size.width <= kMaxImageSide && size.height <= kMaxImageSide)
    context.source.take(field, size_t(size.width) * size.height, 4);
  Image image = decodeImage(bytes, kMaxImagePixels - context.pixels, error);
  if (image.rgba.empty()) context.fail(field, error);
  context.pixels += image.rgba.size() / 4;
  checkMimeType(context, field, mimeType, format);
  if (source.contains("mimeType"))
    checkMimeType(context, field + ".mimeType", source["mimeType"], format);
  return image;
}

}  // namespace

void readImages(GltfContext& context) {
  const auto images = context.source.json.find("images");
  for (size_t i = 0; images != context.source.json.end() && i < images->size(); ++i) {
    const std::string field = fieldAt("images", i);
    const json& source = (*images)[i];
    std::string mimeType;
    if (fileMissing(context, field, source)) {
      context.warn(field + ".uri: file " + shown(source["uri"]) + " not found");
      context.scene.images.emplace_back();
      continue;
    }
    Image image = readImage(context, field, source, mimeType);
    if (const auto name = source.find("name"); name != source.end() && name->is_string())
      image.name = *name;
    else if (source.contains("uri") && mimeType.empty())
      image.name = std::filesystem::path(source["uri"].get<std::string>()).stem().string();
    context.scene.images.push_back(std::move(image));
  }
}

TextureSlot readTextureSlot(GltfContext& context, const std::string& field, int texture,
                            int texCoord, const tinygltf::ExtensionMap& extensions, bool srgb) {
  TextureSlot slot;
  if (texture < 0) return slot;
  const tinygltf::Texture& source = context.model.textures[size_t(texture)];
  const std::string textureField = fieldAt("textures", size_t(texture));
  int image = source.source;
  if (const auto webp = source.extensions.find("EXT_texture_webp");
      webp != source.extensions.end() && webp->second.Has("source"))
    image = webp->second.Get("source").GetNumberAsInt();
  if (image < 0 || context.scene.images[size_t(image)].rgba.empty()) {
    context.warn(field + " is left out: " + textureField + " has no image that could be read");
    return slot;
  }
  slot.image = uint32_t(image);
  slot.srgb = srgb;
  if (source.sampler >= 0) {
    const tinygltf::Sampler& sampler = context.model.samplers[size_t(source.sampler)];
    const std::string samplerField = fieldAt("samplers", size_t(source.sampler));
    slot.wrapU = readWrap(context, samplerField + ".wrapS", sampler.wrapS);
    slot.wrapV = readWrap(context, samplerField + ".wrapT", sampler.wrapT);
    slot.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  }
  if (const auto found = extensions.find("KHR_texture_transform"); found != extensions.end()) {
    slot.uvTransform = transformRows(found->second);
    for (const glm::vec3& row : slot.uvTransform)
      if (!glm::all(glm::lessThan(glm::abs(row), glm::vec3(FLT_MAX))))
        context.fail(field + ".extensions.KHR_texture_transform",
                     "overflows, expected numbers that a 32-bit float can hold");
    if (found->second.Has("texCoord")) texCoord = found->second.Get("texCoord").GetNumberAsInt();
  }
  if (texCoord > 1)
    context.fail(field + ".texCoord",
                 "is " + std::to_string(texCoord) + ", only sets 0 and 1 are supported");
  slot.uvSet = uint32_t(texCoord);
  return slot;
}

}  // namespace sb
