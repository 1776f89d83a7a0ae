// Lookups into maps of several samples a texel, each compared by itself: an average of depths would
// mean nothing (spec 04). Include light_space.glsl before.
layout(constant_id = 21) const uint kMapSamples = 4u;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2DMSArray t_samples;

// Share of lit samples in each channel; outside the map is lit.
vec3 filterSamples(LightSample s) {
  ivec2 size = textureSize(t_samples).xy;
  ivec2 centre = ivec2(floor(s.uvz.xy * float(size.x)));
  // A sample lies up to half a texel from where tapDepth asks, wherever the device puts it.
  s.bias += 0.5 * (abs(s.gradient.x) + abs(s.gradient.y)) * s.texel;
  int h = int(kKernel) / 2;
  vec3 lit = vec3(0);
  float total = 0.0;
  for (int y = -h; y <= h; ++y)
    for (int x = -h; x <= h; ++x) {
      ivec2 texel = centre + ivec2(x, y);
      bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, size));
      float w = kernelWeight(x, y);
      float depth = tapDepth(s, texel);
      total += w * float(kMapSamples);
      for (int i = 0; i < int(kMapSamples); ++i) {
        vec3 depths = outside ? vec3(-1) : texelFetch(t_samples, ivec3(texel, int(s.layer)), i).rgb;
        lit += w * vec3(greaterThanEqual(vec3(depth), depths));
      }
    }
  return lit / total;
}
