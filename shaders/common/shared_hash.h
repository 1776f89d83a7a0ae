// The random numbers of every stochastic technique: an integer hash with one definition for C++ and
// GLSL (index 00, shared code 1), so that maps are bit-identical on every API.
// PCG4D: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3), 2020.
#ifndef SHADOWBENCH_SHARED_HASH_H
#define SHADOWBENCH_SHARED_HASH_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace sb::gpu {
using uvec4 = glm::uvec4;
using vec4 = glm::vec4;
using uint = uint32_t;
#define SHARED inline
#else
#define SHARED
#endif

SHARED uvec4 pcg4d(uvec4 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  v = v ^ (v >> 16u);
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  return v;
}

// Persistent key of a surface element (decision D2): never a draw index, never gl_PrimitiveID.
SHARED uint surfaceKey(uint meshKey, uint instanceKey, uint triangleKey) {
  return pcg4d(uvec4(meshKey, instanceKey, triangleKey, 0x5AD0B3u)).x;
}

// Four independent numbers in [0,1) with 24 bits each, for one texel, surface element, sample of the
// texel and seed (of the run, the light and the face). Never 1: xi < p is never true for p = 0 and always for p = 1.
SHARED vec4 randomNumbers(uint texelX, uint texelY, uint key, uint sampleIndex, uint seed) {
  uvec4 h = pcg4d(uvec4(texelX | (texelY << 16), key, sampleIndex, seed));
  return vec4(h >> 8u) * (1.0f / 16777216.0f);
}

#ifdef __cplusplus
#undef SHARED
}  // namespace sb::gpu
#endif

#endif
