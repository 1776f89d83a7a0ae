// Which of a pixel's samples a fragment keeps. xi belongs to pixel, surface and seed: permuting or
// duplicating draws changes nothing (decision D2).
#include "common/sample_subset.glsl"
layout(constant_id = 32) const uint kSamples = 4u;

uint keptSamples(float alpha, uint key) {
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  uint seed = pcg4d(uvec4(frame.counts.w, 0x7A45u, 0u, 0u)).x;
  return sampleSubset(alpha, kSamples, randomNumbers(pixel.x, pixel.y, key, 0u, seed).xy);
}
