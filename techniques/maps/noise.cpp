#include "techniques/maps/noise.h"

#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/maps/noise_tiles.h"

namespace sb {
namespace {

/// Numbers as in shaders/common/noise.glsl. In a function: techniques register before main.
const std::vector<std::string>& kinds() {
  static const std::vector<std::string> list = {"hash", "texture", "stratified", "blue", "source"};
  return list;
}

}  // namespace

KnobInfo noiseKnob() {
  return {.name = "noise",
          .help =
              "random numbers: a hash; a tile of white or blue noise that each surface reads "
              "elsewhere; strata over blocks as wide as the kernel; Modisett's way (2023), "
              "which is biased",
          .fallback = "hash",
          .choices = kinds(),
          .sweep = kinds()};
}

KnobInfo channelNumbersKnob() {
  return {.name = "numbers",
          .help = "random numbers of the channels: independent, or one shared",
          .fallback = "independent",
          .choices = {"independent", "shared"}};
}

std::map<std::string, std::string> sourceNoiseBreaks() {
  std::map<std::string, std::string> breaks;
  for (const char* id : {"G1", "G2", "H2"})
    breaks[id + std::string(" noise:source")] =
        "the source's pattern hangs on place and scale of the world";
  for (const char* id : {"G10", "H7", "alpha", "certain", "cut-out"})
    breaks[id + std::string(" noise:source")] = "the source's 256 levels block where p = 0";
  for (const char* id : {"between", "coplanar", "layers"})
    breaks[id + std::string(" noise:source")] =
        "the source's numbers belong to places, not to surfaces: layers share them";
  return breaks;
}

Noise::Noise(const Context& context) {
  const std::string& kind = context.knobs.text("noise");
  m_independent = kind == "hash";
  m_constants = {{21, uint32_t(std::ranges::find(kinds(), kind) - kinds().begin())},
                 {22, context.knobs.integer("kernel")}};
  rhi::Device& device = context.device;
  if (kind == "texture") {
    createTile(device, kWhiteWidth, rhi::Format::R32Float, std::as_bytes(std::span(whiteTile())));
  } else if (kind == "blue") {
    createTile(device, kBlueWidth, rhi::Format::R32Float, std::as_bytes(std::span(blueTile())));
  } else if (kind == "source") {
    createTile(device, kSourceWidth, rhi::Format::RGBA8Unorm,
               std::as_bytes(std::span(sourceTile())));
  } else {
    // The shader names a texture that these kinds do not read: any will do.
    m_binding = context.view.gpu().textures(0).front();
    m_binding.slot = rhi::kTextureSlotBase + TEXTURE_TECHNIQUE;
  }
}

void Noise::createTile(rhi::Device& device, uint32_t width, rhi::Format format,
                       std::span<const std::byte> texels) {
  m_tile = device.createTexture({.label = "noise",
                                 .format = format,
                                 .width = width,
                                 .height = width,
                                 .use = rhi::TextureUse::Sampled | rhi::TextureUse::CopyTarget});
  device.upload(m_tile, {}, texels);
  m_sampler = device.createSampler({.label = "noise points", .filter = rhi::Filter::Nearest});
  m_binding = rhi::textureAt(TEXTURE_TECHNIQUE, m_tile, m_sampler);
}

}  // namespace sb
