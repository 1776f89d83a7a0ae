// Reads the stochastic depths of a pixel.
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 1)) uniform sampler2D t_depths0;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 2)) uniform sampler2D t_depths1;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 3)) uniform sampler2D t_depths2;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 4)) uniform sampler2D t_depths3;

// Share of samples, by channel, in which nothing nearer than `depth` hides it.
vec3 visibleFrom(float depth) {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 z = vec3(depth);
  vec3 seen = vec3(lessThanEqual(texelFetch(t_depths0, pixel, 0).rgb, z));
  if (kSamples == 1u) return seen;
  seen += vec3(lessThanEqual(texelFetch(t_depths1, pixel, 0).rgb, z));
  seen += vec3(lessThanEqual(texelFetch(t_depths2, pixel, 0).rgb, z));
  seen += vec3(lessThanEqual(texelFetch(t_depths3, pixel, 0).rgb, z));
  return seen * 0.25;
}
