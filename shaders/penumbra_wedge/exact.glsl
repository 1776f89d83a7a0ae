// What casters hide from a receiver, without rasterisation (spec 08, REFERENCE_TILE): whether they
// hide the light's centre, from their triangles, less the shares of all edges of their silhouettes,
// by one arithmetic.
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 1), std430) readonly buffer WedgeCasterBlock {
  WedgeCaster casters[];
};
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 2), std430) readonly buffer WedgeTriangleBlock {
  WedgeTriangle castingTriangles[];
};

// May anything within a sphere (relative to the eye; w: radius) lie between the receiver and what is
// at most so far from the light's centre, in its plane?
bool mayHide(WedgeReceiver r, vec4 sphere, float within) {
  vec3 s = seenPoint(r.sight, sphere.xyz - r.position);
  vec3 size = sphere.w * vec3(length(r.sight.rowX), length(r.sight.rowY), length(r.sight.rowZ));
  return s.z + size.z > 0.0 && s.z - size.z < r.sight.far &&
         length(s.xy) - length(size.xy) <= within * (s.z + size.z);
}

float hiddenByTriangles(WedgeReceiver r, WedgeCaster caster) {
  float count = 0.0;
  for (uint t = caster.parts.z; t < caster.parts.z + caster.parts.w; ++t) {
    vec3 from[3], seen[3];
    for (uint k = 0u; k < 3u; ++k) {
      from[k] = castingTriangles[t].corners[k].xyz - r.position;
      seen[k] = seenPoint(r.sight, from[k]);
    }
    if (hidesCentre(r.sight, seen[0], seen[1], seen[2],
                    wayToPlane(from[0], from[1], from[2], r.toLight)))
      count += 1.0;
  }
  return count;
}

// How often the light's centre is hidden: what volumes count.
float centreHiddenByAll(WedgeReceiver r) {
  float count = 0.0;
  for (uint i = 0u; i < wedgeLight.ids.y; ++i)
    if (mayHide(r, casters[i].sphere, 0.0)) count += hiddenByTriangles(r, casters[i]);
  return count;
}

float hiddenByCaster(WedgeReceiver r, WedgeCaster caster) {
  float hidden = hiddenByTriangles(r, caster);
  for (uint i = caster.parts.x; i < caster.parts.x + caster.parts.y; ++i)
    hidden -= wedgeShare(r, wedges[i]);
  return hidden;
}

// Shadows of casters add up: where they overlap, the light is counted as hidden twice.
float hiddenByAll(WedgeReceiver r) {
  float hidden = 0.0;
  for (uint i = 0u; i < wedgeLight.ids.y; ++i)
    if (mayHide(r, casters[i].sphere, 1.4142136)) hidden += max(hiddenByCaster(r, casters[i]), 0.0);
  return hidden;
}
