// Which of a pixel's samples a fragment keeps: R = floor(alpha S + xi) of them, each set of R equally
// likely (Enderton et al. 2010). xi belongs to pixel, surface and seed: permuting or duplicating
// draws changes nothing (decision D2).
layout(constant_id = 32) const uint kSamples = 4u;

uint keptSamples(float alpha, uint key) {
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  uint seed = pcg4d(uvec4(frame.counts.w, 0x7A45u, 0u, 0u)).x;
  vec4 xi = randomNumbers(pixel.x, pixel.y, key, 0u, seed);
  uint kept = min(uint(floor(alpha * float(kSamples) + xi.x)), kSamples);
  if (kSamples == 1u) return kept;
  if (kept == 0u) return 0u;
  uint one = 1u << uint(xi.y * 4.0);
  if (kept == 1u) return one;
  if (kept == 3u) return 15u ^ one;
  if (kept == 4u) return 15u;
  const uint pairs[6] = uint[6](3u, 5u, 6u, 9u, 10u, 12u);
  return pairs[uint(xi.y * 6.0)];
}
