// How much of the light each caster hides from a receiver, without rasterisation (spec 08,
// REFERENCE_TILE): whether it hides the centre, from its triangles, less the shares of all edges of
// its silhouette, by one arithmetic.
#include "common/transform.glsl"
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 1), std430) readonly buffer WedgeCasterBlock {
  WedgeCaster casters[];
};
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 2), std430) readonly buffer CornerBlock {
  uint corners[];
};
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 3), std430) readonly buffer PositionBlock {
  float positions[];
};

// In mesh space.
vec3 cornerOf(VolumeData volume, uint triangle, uint corner) {
  uint at = volume.first.z + 3u * corners[volume.first.y + 3u * triangle + corner];
  return vec3(positions[at], positions[at + 1u], positions[at + 2u]);
}

// May anything within a sphere (relative to the eye; w: radius) lie between receiver and light?
bool mayHide(WedgeReceiver r, vec4 sphere) {
  vec3 s = seenPoint(r.sight, sphere.xyz - r.position);
  vec3 size = sphere.w * vec3(length(r.sight.rowX), length(r.sight.rowY), length(r.sight.rowZ));
  return s.z + size.z > 0.0 && s.z - size.z < r.sight.far &&
         length(s.xy) - length(size.xy) < 1.4142136 * (s.z + size.z);
}

float hiddenByTriangles(WedgeReceiver r, VolumeData volume) {
  float count = 0.0;
  for (uint t = 0u; t < volume.counts.y; ++t) {
    vec3 p[3], seen[3];
    for (uint k = 0u; k < 3u; ++k) {
      p[k] = cornerOf(volume, t, k);
      seen[k] = seenPoint(r.sight,
                          toRelative(volume.row0, volume.row1, volume.row2, p[k]) - r.position);
    }
    if (hidesCentre(r.sight, seen[0], seen[1], seen[2]) && casts(volume, p[0], p[1], p[2]) != 0)
      count += 1.0;
  }
  return count;
}

float hiddenByCaster(WedgeReceiver r, WedgeCaster caster) {
  float hidden = hiddenByTriangles(r, caster.volume);
  for (uint i = 0u; i < caster.wedges.y; ++i)
    hidden -= wedgeShare(r, wedges[caster.wedges.x + i]);
  return hidden;
}

// Shadows of casters add up: where they overlap, the light is counted as hidden twice.
float hiddenByAll(WedgeReceiver r) {
  float hidden = 0.0;
  for (uint i = 0u; i < wedgeLight.ids.z; ++i) {
    WedgeCaster caster = casters[wedgeLight.ids.y + i];
    if (mayHide(r, caster.sphere)) hidden += max(hiddenByCaster(r, caster), 0.0);
  }
  return hidden;
}
