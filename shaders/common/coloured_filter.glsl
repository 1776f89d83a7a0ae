// What a lookup into three kinds of map shares: opaque depth and, per tap, a colour that the light
// keeps on its way there. Mixed per tap, before averaging: a colour must not bleed over the outline
// of what made it (spec 02, P3).

// Averages tapColour over the lit taps of the filter; outside the map is lit. The including shader
// has defined vec3 tapColour(LightSample s, ivec2 texel, float depth, uvec4 which); `which` is handed
// through.
vec3 filterOverOpaque(sampler2DArray opaque, LightSample s, uvec4 which) {
  int size = textureSize(opaque, 0).x;
  ivec2 centre = ivec2(floor(s.uvz.xy * float(size)));
  int h = int(kKernel) / 2;
  vec3 lit = vec3(0);
  float total = 0.0;
  for (int y = -h; y <= h; ++y)
    for (int x = -h; x <= h; ++x) {
      ivec2 texel = centre + ivec2(x, y);
      bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(size)));
      float w = kernelWeight(x, y);
      total += w;
      float depth = tapDepth(s, texel);
      if (outside)
        lit += vec3(w);
      else if (depth >= texelFetch(opaque, ivec3(texel, int(s.layer)), 0).r)
        lit += w * tapColour(s, texel, depth, which);
    }
  return lit / total;
}
