// Participating media in boxes (spec 14): their record, their density and how they scatter, one
// definition for C++ and GLSL. C++ computes in double, shaders in float; the lattice of the noise is
// the same integers for both. Positions in a box: the unit cube, y up.
// The smoke's centre line needs sines, which Vulkan computes to 2^-11 only. In place of a table of
// them stands a polynomial: + and * are rounded alike on every API, and nothing has to be bound.
// GLSL includes common/shared_hash.h first.
#ifndef SHADOWBENCH_SHARED_MEDIUM_H
#define SHADOWBENCH_SHARED_MEDIUM_H

#ifdef __cplusplus
#include <cstddef>

#include "shaders/common/shared_hash.h"
namespace sb::gpu {
using real = double;
using real2 = glm::dvec2;
using real3 = glm::dvec3;
using glm::abs;
using glm::clamp;
using glm::floor;
using glm::ivec3;
using glm::length;
using glm::max;
using glm::mix;
using glm::sqrt;
using glm::uvec3;
#define SHARED inline
#else
#define SHARED
#define real float
#define real2 vec2
#define real3 vec3
#endif

#define MEDIUM_HOMOGENEOUS 0u
#define MEDIUM_SMOKE 1u
#define MEDIUM_GRID 2u
#define MAX_MEDIA 16

struct MediumData {
  vec4 toBox0;  // rows of camera-relative world -> unit cube
  vec4 toBox1;
  vec4 toBox2;
  vec4 extinction;  // rgb: sigma_t of density 1, per world unit; w: Henyey-Greenstein's g
  vec4 albedo;      // rgb
  vec4 smoke;       // x: SmokeShape::turn, y: SmokeShape::shift
  uvec4 ids;        // x: MEDIUM_*, y: SmokeShape::seed, z: SmokeShape::drift
};

// The uniform block UNIFORM_MEDIA.
struct MediaBlock {
  uvec4 count;  // x
  MediumData media[MAX_MEDIA];
};

// What tells one column of smoke from another.
struct SmokeShape {
  real turn;   // phase of its centre line, in turns
  real shift;  // how far the noise has risen: fractions of a cell ...
  uint drift;  // ... and whole cells
  uint seed;
};

// Sine of x turns, to 6e-8.
SHARED real sinTurns(real x) {
  x -= floor(x + real(0.5));
  real z = (real(0.25) - abs(abs(x) - real(0.25))) * real(6.283185307179586);
  real q = z * z;
  real s = z * (real(1.0) - q / real(6.0) * (real(1.0) - q / real(20.0) *
           (real(1.0) - q / real(42.0) * (real(1.0) - q / real(72.0) *
           (real(1.0) - q / real(110.0))))));
  return x < real(0.0) ? -s : s;
}

// 0 at `low` and below, 1 at `high` and above, smooth between; low < high.
SHARED real ramp(real low, real high, real x) {
  real t = clamp((x - low) / (high - low), real(0.0), real(1.0));
  return t * t * (real(3.0) - real(2.0) * t);
}

// Value of a lattice point: 24 bits in [0,1), exact in floats.
SHARED real latticeValue(uvec3 cell, uint seed) {
  return real(pcg4d(uvec4(cell, seed)).x >> 8u) * real(1.0 / 16777216.0);
}

// Value noise with a quintic fade, in [0,1). The lattice is `drift` cells further up than p says.
SHARED real valueNoise(real3 p, uint drift, uint seed) {
  real3 whole = floor(p);
  uvec3 c = uvec3(ivec3(whole));
  c.y -= drift;
  real3 f = p - whole;
  f = f * f * f * (f * (f * real(6.0) - real(15.0)) + real(10.0));
  uvec3 d = c + 1u;
  real nearLow = mix(latticeValue(c, seed), latticeValue(uvec3(d.x, c.y, c.z), seed), f.x);
  real nearHigh = mix(latticeValue(uvec3(c.x, d.y, c.z), seed),
                      latticeValue(uvec3(d.x, d.y, c.z), seed), f.x);
  real farLow = mix(latticeValue(uvec3(c.x, c.y, d.z), seed),
                    latticeValue(uvec3(d.x, c.y, d.z), seed), f.x);
  real farHigh = mix(latticeValue(uvec3(c.x, d.y, d.z), seed), latticeValue(d, seed), f.x);
  return mix(mix(nearLow, nearHigh, f.y), mix(farLow, farHigh, f.y), f.z);
}

// Four octaves, gain 1/2, lacunarity 2, each with a lattice of its own; in [0,1).
SHARED real fractalNoise(real3 p, uint drift, uint seed) {
  real sum = real(0.0), gain = real(8.0 / 15.0);
  for (uint octave = 0u; octave < 4u; ++octave) {
    sum += gain * valueNoise(p, drift, seed + octave * 0x9E3779B9u);
    gain *= real(0.5);
    p *= real(2.0);
    drift *= 2u;
  }
  return sum;
}

// A rising column of smoke, in [0,1).
SHARED real smokeDensity(SmokeShape s, real3 q) {
  const real perTurn = real(0.15915494309189535);
  real fade = ramp(real(0.0), real(0.05), q.y) * (real(1.0) - ramp(real(0.85), real(1.0), q.y));
  real2 centre = real2(sinTurns(real(6.0) * perTurn * q.y + real(2.0) * s.turn),
                       sinTurns(real(5.0) * perTurn * q.y + s.turn + real(0.25))) * real(0.06);
  real aside = length(real2(q.x, q.z) - real(0.5) - centre) / (real(0.12) + real(0.25) * q.y);
  real base = (real(1.0) - ramp(real(0.4), real(1.0), aside)) * fade;
  if (base <= real(0.0)) return real(0.0);
  real n = fractalNoise(real3(real(8.0) * q.x, real(6.0) * q.y - s.shift, real(8.0) * q.z), s.drift,
                        s.seed);
  return base * max(real(0.0), n - real(0.25)) / real(0.75);
}

// Share of what is scattered that goes a way at an angle to the light's, per steradian; cosine 1:
// straight on. All of it straight on (g = 1) is no scattering that can be seen.
SHARED real henyeyGreenstein(real g, real cosine) {
  real d = max(real(1.0) + g * g - real(2.0) * g * cosine, real(1e-8));
  return (real(1.0) - g * g) / (real(12.566370614359172) * d * sqrt(d));
}

#ifdef __cplusplus
static_assert(offsetof(MediumData, toBox1) == 16 && offsetof(MediumData, toBox2) == 32 &&
              offsetof(MediumData, extinction) == 48 && offsetof(MediumData, albedo) == 64 &&
              offsetof(MediumData, smoke) == 80 && offsetof(MediumData, ids) == 96 &&
              sizeof(MediumData) == 112);
static_assert(offsetof(MediaBlock, media) == 16 && sizeof(MediaBlock) == 16 + 16 * 112);
#undef SHARED
}  // namespace sb::gpu
#endif

#endif
