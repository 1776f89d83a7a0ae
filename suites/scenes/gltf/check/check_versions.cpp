// Versions and extensions: what is read, what may be left out, what is refused.
#include <algorithm>
#include <array>

#include "base/number.h"
#include "suites/scenes/gltf/check/check.h"

namespace sb {
namespace {

using nlohmann::json;

constexpr std::string_view kRead[] = {
    "EXT_mesh_gpu_instancing",    "EXT_meshopt_compression", "EXT_texture_webp",
    "KHR_draco_mesh_compression", "KHR_lights_punctual",     "KHR_materials_emissive_strength",
    "KHR_materials_transmission", "KHR_materials_unlit",     "KHR_materials_volume",
    "KHR_mesh_quantization",      "KHR_node_visibility",     "KHR_texture_transform"};

// Extensions that change neither where a surface is nor how much light it lets through: a file that
// requires one loads without it. Of spec-gloss materials the diffuse colour is read.
constexpr std::string_view kHarmless[] = {"ADOBE_materials_clearcoat_specular",
                                          "ADOBE_materials_clearcoat_tint",
                                          "ADOBE_materials_thin_transparency",
                                          "AGI_articulations",
                                          "AGI_stk_metadata",
                                          "CESIUM_primitive_outline",
                                          "EXT_feature_metadata",
                                          "EXT_instance_features",
                                          "EXT_lights_image_based",
                                          "EXT_materials_bump",
                                          "EXT_mesh_features",
                                          "EXT_structural_metadata",
                                          "FB_geometry_metadata",
                                          "KHR_materials_anisotropy",
                                          "KHR_materials_clearcoat",
                                          "KHR_materials_dispersion",
                                          "KHR_materials_ior",
                                          "KHR_materials_iridescence",
                                          "KHR_materials_pbrSpecularGlossiness",
                                          "KHR_materials_sheen",
                                          "KHR_materials_specular",
                                          "KHR_materials_variants",
                                          "KHR_node_hoverability",
                                          "KHR_node_selectability",
                                          "KHR_xmp",
                                          "KHR_xmp_json_ld",
                                          "MSFT_lod",
                                          "MSFT_packing_normalRoughnessMetallic",
                                          "MSFT_packing_occlusionRoughnessMetallic"};

bool isOneOf(std::span<const std::string_view> names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

// {major, minor} of "2.0"; fails on other forms.
std::array<int, 2> version(const GltfSource& source, const std::string& field,
                           const std::string& text) {
  const size_t dot = std::min(text.find('.'), text.size());
  const std::string_view all = text;
  const auto part = [](std::string_view digits) { return base::readWhole(digits, 0, 1 << 30); };
  const auto major = part(all.substr(0, dot));
  const auto minor = part(all.substr(std::min(dot + 1, text.size())));
  if (!major || !minor)
    source.fail(field, "is " + shown(text) + ", expected a version like \"2.0\"");
  return {int(*major), int(*minor)};
}

}  // namespace

void refuseOldVersions(const GltfSource& source) {
  const json& j = source.json;
  const json::json_pointer at("/asset/version");
  const bool stated = j.contains(at) && j[at].is_string();
  if (stated && j[at].get_ref<const std::string&>().starts_with("1."))
    source.fail("asset.version", "is " + shown(j[at]) +
                                     ", expected 2.x: this is a glTF 1.0 file, whose form differs "
                                     "in all parts; convert it to 2.0");
  // Version 1.0 may leave its number out; its collections are objects by name.
  if (stated) return;
  for (const char* key : {"meshes", "nodes", "accessors", "buffers", "scenes"})
    if (j.contains(key) && j[key].is_object())
      source.fail(key,
                  "is an object and asset.version is missing: this is a glTF 1.0 file, "
                  "expected glTF 2.0; convert it");
}

void checkAsset(GltfSource& source) {
  const json& asset = source.json["asset"];
  const auto stated = version(source, "asset.version", asset["version"]);
  if (stated[0] != 2)
    source.fail("asset.version", "is " + shown(asset["version"]) + ", expected 2.x");
  if (!asset.contains("minVersion")) return;
  const auto least = version(source, "asset.minVersion", asset["minVersion"]);
  if (least > std::array<int, 2>{2, 0})
    source.fail("asset.minVersion", "is " + shown(asset["minVersion"]) + ", expected at most 2.0");
}

void checkExtensions(GltfSource& source) {
  const json& required = source.list("extensionsRequired");
  for (size_t i = 0; i < required.size(); ++i) {
    const std::string name = required[i];
    if (isOneOf(kRead, name)) continue;
    const std::string field = "extensionsRequired[" + std::to_string(i) + "]";
    if (name == "KHR_texture_basisu")
      source.fail(field, "is " + shown(name) +
                             ": KTX2 textures are not supported, no packaged library reads them; "
                             "convert them to PNG, JPEG or WebP (gltf-transform ktxdecompress)");
    if (!isOneOf(kHarmless, name))
      source.fail(field, "is " + shown(name) + ", an extension that is not supported");
    source.warn("extension " + name +
                " is required but not supported; it changes no shadow and is "
                "left out");
  }
  for (const json& entry : source.list("extensionsUsed")) {
    const std::string name = entry;
    if (!isOneOf(kRead, name) && std::ranges::find(required, entry) == required.end())
      source.warn("extension " + name + " is not supported and ignored");
  }
}

}  // namespace sb
