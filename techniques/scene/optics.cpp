// Decision D8 in code: optics() is the shaders' own definition (shaders/common/shared_optics.h);
// materialTraits() bounds what optics() can return over the texels and vertex colours in use.
#include "techniques/scene/optics.h"

#include <algorithm>
#include <cmath>

#include "shaders/common/shared_optics.h"
#include "techniques/scene/material_data.h"

namespace sb {
namespace {

// Smallest and largest value that one factor of the optics takes over a material.
struct Range {
  float low = 1, high = 1;
  void scale(float factor) { low *= factor, high *= factor; }
  void scale(const Range& o) { low *= o.low, high *= o.high; }
};

// What base colour, transmission and thickness range over, everywhere the material is used.
struct Inputs {
  Range channels[4];    ///< r, g, b, a of the base colour
  bool grey = true;     ///< r = g = b everywhere
  bool varies = false;  ///< some base colour channel does
  Range metallic;
  Range transmission;
  Range thickness;
};

// Bilinear filtering stays within the range of the texels; so do its sRGB-decoded values, for
// decoding is monotonic.
Range texelRange(const Scene& scene, const TextureSlot& slot, int channel) {
  if (!slot.present()) return {};
  const Image& image = scene.images.at(slot.image);
  uint8_t low = 255, high = 0;
  for (size_t i = size_t(channel); i < image.rgba.size(); i += 4) {
    low = std::min(low, image.rgba[i]);
    high = std::max(high, image.rgba[i]);
  }
  const auto decode = [&](uint8_t texel) {
    const float c = float(texel) / 255.0f;
    if (!slot.srgb || channel == 3) return c;
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  };
  return {decode(low), decode(high)};
}

bool greyTexels(const Scene& scene, const TextureSlot& slot) {
  if (!slot.present()) return true;
  const std::vector<uint8_t>& t = scene.images.at(slot.image).rgba;
  for (size_t i = 0; i + 3 < t.size(); i += 4)
    if (t[i] != t[i + 1] || t[i] != t[i + 2]) return false;
  return true;
}

void applyVertexColours(const Scene& scene, const Material& material, Inputs& inputs) {
  // Also callable with a copy of a material that the scene does not hold: then no mesh uses it.
  const auto holds = [&](const Mesh& mesh) {
    return !mesh.colors.empty() && &scene.materials.at(mesh.material) == &material;
  };
  if (std::ranges::none_of(scene.meshes, holds)) return;
  glm::vec4 low(1), high(0);
  bool bare = false;
  for (const Mesh& mesh : scene.meshes) {
    if (&scene.materials.at(mesh.material) != &material) continue;
    bare |= mesh.colors.empty();
    for (const glm::vec4& c : mesh.colors) {
      low = glm::min(low, c), high = glm::max(high, c);
      if (c.r != c.g || c.r != c.b) inputs.grey = false;
    }
  }
  if (bare) high = glm::max(high, glm::vec4(1));
  for (int c = 0; c < 4; ++c) {
    inputs.channels[c].scale({low[c], high[c]});
    inputs.varies |= low[c] != high[c];
  }
}

Inputs inputsOf(const Scene& scene, const Material& m) {
  Inputs inputs;
  for (int c = 0; c < 4; ++c) {
    inputs.channels[c] = texelRange(scene, m.baseColorTexture, c);
    inputs.varies |= inputs.channels[c].low != inputs.channels[c].high;
    inputs.channels[c].scale(m.baseColor[c]);
  }
  inputs.grey = m.baseColor.r == m.baseColor.g && m.baseColor.r == m.baseColor.b &&
                greyTexels(scene, m.baseColorTexture);
  applyVertexColours(scene, m, inputs);
  inputs.metallic = texelRange(scene, m.metallicRoughnessTexture, 2);
  inputs.metallic.scale(m.metallic);
  inputs.transmission = texelRange(scene, m.transmissionTexture, 0);
  inputs.transmission.scale(m.transmission);
  inputs.thickness = texelRange(scene, m.thicknessTexture, 1);
  inputs.thickness.scale(m.thickness);
  return inputs;
}

bool sameChannels(glm::vec3 c) { return c.r == c.g && c.r == c.b; }

MaterialTraits overriddenTraits(const Material& m) {
  const Optics o = optics(m, {m.baseColor, m.metallic, m.transmission, m.thickness});
  MaterialTraits traits;
  const bool opaque = o.alpha == 1 && o.transmission == glm::vec3(0);
  traits.lightClass = opaque ? MaterialClass::Opaque : MaterialClass::Translucent;
  traits.cameraTranslucent = o.behind != glm::vec3(0);
  traits.coloured = o.alpha > 0 && !sameChannels(o.transmission);
  traits.cameraColoured = o.behind != glm::vec3(1 - o.alpha);
  return traits;
}

MaterialTraits transmissiveTraits(const Material& m, const Inputs& in) {
  const bool holes = m.alphaMode == AlphaMode::Mask && in.channels[3].low < m.alphaCutoff;
  const bool thins = m.alphaMode == AlphaMode::Blend && in.channels[3].low < 1;
  const float brightest = std::max({in.channels[0].high, in.channels[1].high, in.channels[2].high});
  const bool transmits = in.transmission.high > 0 && brightest > 0 && in.metallic.low < 1;
  const bool attenuates = in.thickness.high > 0 && std::isfinite(m.attenuationDistance);
  const bool covers = m.alphaMode != AlphaMode::Blend || in.channels[3].high > 0;
  MaterialTraits traits;
  traits.lightClass = transmits || thins ? MaterialClass::Translucent
                      : holes            ? MaterialClass::Perforated
                                         : MaterialClass::Opaque;
  traits.cameraTranslucent = transmits || thins;
  traits.cameraColoured = transmits && covers;
  traits.textured =
      (thins && in.varies) ||
      (transmits &&
       (in.varies || in.transmission.low != in.transmission.high ||
        in.metallic.low != in.metallic.high ||
        (attenuates && in.thickness.low != in.thickness.high) || holes));
  traits.coloured = transmits && (!in.grey || (attenuates && !sameChannels(m.attenuationColor)));
  return traits;
}

}  // namespace

Optics optics(const Material& material, const OpticsPoint& point) {
  const gpu::OpticsData o = gpu::opticsOf(materialData(material), point.baseColor, point.metallic,
                                          point.transmission, point.thickness);
  return {.alpha = o.alpha, .transmission = o.t, .behind = o.behind};
}

MaterialTraits materialTraits(const Scene& scene, const Material& m) {
  MaterialTraits traits;
  if (m.opticsOverride) return overriddenTraits(m);
  if (m.transmission <= 0 && m.alphaMode == AlphaMode::Opaque) return traits;

  const Inputs in = inputsOf(scene, m);
  if (m.transmission > 0) return transmissiveTraits(m, in);
  if (m.alphaMode == AlphaMode::Mask) {
    if (in.channels[3].low < m.alphaCutoff) traits.lightClass = MaterialClass::Perforated;
    return traits;
  }
  const float brightest = std::max({in.channels[0].high, in.channels[1].high, in.channels[2].high});
  const bool solid = in.channels[3].low >= 1 && brightest <= 0;
  traits.lightClass = solid ? MaterialClass::Opaque : MaterialClass::Translucent;
  traits.cameraTranslucent = in.channels[3].low < 1;
  traits.textured = !solid && in.varies;
  traits.coloured = !solid && !in.grey;
  return traits;
}

}  // namespace sb
