// Random numbers of a texel and a surface, in the kinds of techniques/maps/noise.h. In each, a
// surface draws numbers of its own at every texel: layers must be independent (spec 03, "Random
// numbers"). Include scene.glsl, shared_hash.h and light_pass.glsl before.
layout(constant_id = 21) const uint kNoise = 0u;       // NOISE_*
layout(constant_id = 22) const uint kNoiseBlock = 1u;  // width of a stratified block, texels
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2D t_noise;

#define NOISE_HASH 0u
#define NOISE_TEXTURE 1u
#define NOISE_STRATIFIED 2u
#define NOISE_BLUE 3u
#define NOISE_SOURCE 4u

float shiftedNoise(uvec2 texel, uint shift) {
  uvec2 at = texel + uvec2(shift >> 8u, shift >> 20u);
  return texelFetch(t_noise, ivec2(at & uint(textureSize(t_noise, 0).x - 1)), 0).r;
}

// Each surface, sample and channel reads the tile elsewhere: a shift in SPACE. One position for all
// gives all layers one number; adding to the VALUE fixes the joint distribution of two layers.
vec4 tileNumbers(uvec2 texel, uint key, uint sampleIndex, uint seed) {
  uvec4 shift = pcg4d(uvec4(key, sampleIndex, seed, 0x7E13u));
  return vec4(shiftedNoise(texel, shift.x), shiftedNoise(texel, shift.y),
              shiftedNoise(texel, shift.z), shiftedNoise(texel, shift.w));
}

// Place of `i` in a random order of 0..count-1: steps that can be undone on the next power of two
// (odd factors, sums, shifts), repeated while they lead outside, and a turn by a uniform number, which
// makes every place equally likely whatever the steps.
uint permuted(uint i, uint count, uvec4 words) {
  uint mask = count - 1u;
  mask |= mask >> 1u;
  mask |= mask >> 2u;
  mask |= mask >> 4u;
  mask |= mask >> 8u;
  uint halfBits = uint(max(1, (findMSB(mask) + 1) / 2));
  for (int step = 0; step < 64; ++step) {
    i = (i * (words.x | 1u) + words.y) & mask;
    i ^= i >> halfBits;
    i = (i * (words.z | 1u) + (words.y >> 16u)) & mask;
    i ^= i >> halfBits;
    i = (i * ((words.x >> 16u) | 1u)) & mask;
    i ^= i >> halfBits;
    if (i < count) break;
  }
  return (i + uint(float(words.w >> 8u) * (1.0 / 16777216.0) * float(count))) % count;
}

// Each block of k x k texels takes one number from each of k^2 equal parts of [0,1).
vec4 stratifiedNumbers(uvec2 texel, uint key, uint sampleIndex, uint seed, uvec4 h) {
  uint count = kNoiseBlock * kNoiseBlock;
  uvec2 block = texel / kNoiseBlock, inside = texel % kNoiseBlock;
  uint j = inside.y * kNoiseBlock + inside.x;
  uvec4 place;
  for (uint c = 0u; c < 4u; ++c)
    place[c] = permuted(j, count, pcg4d(uvec4(block.x | (block.y << 16), key, sampleIndex * 4u + c,
                                              seed ^ 0x57A7u)));
  // Place and the number within a part share a float's 24 bits: their sum is exact, and stays in
  // its part.
  int bits = findMSB(count - 1u) + 1;
  float unit = uintBitsToFloat(uint(103 + bits) << 23);  // 2^(bits - 24)
  vec4 xi = (vec4(place) + vec4(h >> uint(8 + bits)) * unit) / float(count);
  return min(xi, vec4(1.0 - 1.0 / 16777216.0));
}

// As Modisett's program does it: a tile over the world, 2048 texels a unit, looked up by
// position and texture coordinates (how it joins the three and the two is not told). Nothing in it
// belongs to the surface, and its 256 levels include 0.
vec4 sourceNumbers(uint seed, vec2 uv) {
  ShadowViewData view = shadowViewAt(PASS_SHADOW_VIEW);
  vec3 ndc = vec3(gl_FragCoord.xy * view.texel.x * 2.0 - 1.0, gl_FragCoord.z);
  vec4 p = transpose(view.planeToClip) * vec4(ndc, 1);  // planes go the inverse way transposed
  vec3 world = p.xyz / p.w + view.origin.xyz + frame.eye.xyz;
  vec2 shift = vec2(seed & 2047u, (seed >> 11u) & 2047u) / 2048.0;
  return textureLod(t_noise, world.xy + world.zz + uv + shift, 0.0);
}

// Four numbers in [0,1) of the texel at hand; `uv` matters to Modisett's kind alone.
vec4 noiseNumbers(uint key, uint sampleIndex, vec2 uv) {
  uvec2 texel = uvec2(gl_FragCoord.xy);
  uint seed = pcg4d(uvec4(frame.counts.w, shadowViewAt(PASS_SHADOW_VIEW).ids.x, 0u, 0u)).x;
  if (kNoise == NOISE_TEXTURE) return tileNumbers(texel, key, sampleIndex, seed);
  if (kNoise == NOISE_SOURCE) return sourceNumbers(seed, uv);
  if (kNoise == NOISE_HASH) return randomNumbers(texel.x, texel.y, key, sampleIndex, seed);
  uvec4 h = pcg4d(uvec4(texel.x | (texel.y << 16), key, sampleIndex, seed));
  if (kNoise == NOISE_STRATIFIED) return stratifiedNumbers(texel, key, sampleIndex, seed, h);
  // A tile of 4096 ranks: what lies between two ranks is drawn anew, so that no p is rounded.
  return tileNumbers(texel, key, sampleIndex, seed) + vec4(h >> 20u) * (1.0 / 16777216.0);
}

// Whether numbers block at probabilities p: p = 0 never does and p = 1 always does, but in the source
// document's program, which compares the other way.
bvec3 noiseBlocks(vec3 numbers, vec3 p) {
  return kNoise == NOISE_SOURCE ? lessThanEqual(numbers, p) : lessThan(numbers, p);
}
