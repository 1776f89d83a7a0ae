// Where stochastic shadow maps take their random numbers from (shaders/common/noise.glsl; spec 03,
// "Random numbers"). In every kind but one each surface draws by itself at every texel, so that the
// mean over seeds is right; kinds differ in cost and in how fast a filter averages noise away.
//   hash        integer hash of texel, surface, sample and seed; independent; the default
//   texture     a tile of white noise, read elsewhere by every surface; repeats after 256 texels
//   stratified  one number of each of N^2 equal parts in every block as wide as the filter
//   blue        a tile of blue noise, read elsewhere by every surface; repeats after 64 texels
//   source      as Modisett's program does it: 8 bits by world position; p = 0 blocks
//               one texel in 256, and the pattern depends on the scale of the world
#pragma once

#include "techniques/render/technique.h"

namespace sb {

KnobInfo noiseKnob();
/// Knob numbers of techniques with three channels.
KnobInfo channelNumbersKnob();

/// Hard cases that noise=source does not pass by construction, for TechniqueInfo::breaksIn.
std::map<std::string, std::string> sourceNoiseBreaks();

class Noise {
 public:
  /// By knob noise. Creates a tile only for kinds that read one.
  explicit Noise(const Context& context);

  /// Binding of the light passes that draw numbers; of a texture that is not read when there is no
  /// tile.
  rhi::Binding binding() const { return m_binding; }
  /// Constants 21 and 22 of noise.glsl.
  const std::vector<rhi::SpecConstant>& constants() const { return m_constants; }
  /// Whether numbers of different texels are independent: what a binomial test needs.
  bool independent() const { return m_independent; }

 private:
  void createTile(rhi::Device& device, uint32_t width, rhi::Format format,
                  std::span<const std::byte> texels);

  rhi::Texture m_tile;
  rhi::Sampler m_sampler;
  rhi::Binding m_binding;
  std::vector<rhi::SpecConstant> m_constants;
  bool m_independent = true;
};

}  // namespace sb
