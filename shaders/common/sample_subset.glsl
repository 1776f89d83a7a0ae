// Which samples of a texel a fragment keeps: R = floor(a M + xi) of M = 1 or 4, each set of R equally
// likely (Enderton et al. 2010, stratified). One bit a sample.
uint sampleSubset(float a, uint samples, vec2 xi) {
  uint kept = min(uint(floor(a * float(samples) + xi.x)), samples);
  if (samples == 1u) return kept;
  if (kept == 0u) return 0u;
  uint one = 1u << uint(xi.y * 4.0);
  if (kept == 1u) return one;
  if (kept == 3u) return 15u ^ one;
  if (kept == 4u) return 15u;
  const uint pairs[6] = uint[6](3u, 5u, 6u, 9u, 10u, 12u);
  return pairs[uint(xi.y * 6.0)];
}
