#ifndef TRANSFORM_GLSL
#define TRANSFORM_GLSL
// Positions, in arithmetic that every API must keep (decision D1): sums written out and `precise`.
vec3 toRelative(InstanceData i, vec3 p) {
  precise vec3 r;
  r.x = i.toRelative0.x * p.x + i.toRelative0.y * p.y + i.toRelative0.z * p.z + i.toRelative0.w;
  r.y = i.toRelative1.x * p.x + i.toRelative1.y * p.y + i.toRelative1.z * p.z + i.toRelative1.w;
  r.z = i.toRelative2.x * p.x + i.toRelative2.y * p.y + i.toRelative2.z * p.z + i.toRelative2.w;
  return r;
}

vec4 toClip(mat4 m, vec3 p) {
  precise vec4 c = m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
  return c;
}

// A direction (normal) through the cofactor rows of an instance.
vec3 normalToWorld(InstanceData i, vec3 n) {
  return vec3(dot(i.normal0.xyz, n), dot(i.normal1.xyz, n), dot(i.normal2.xyz, n));
}

vec3 tangentToWorld(InstanceData i, vec3 t) {
  return vec3(dot(i.toRelative0.xyz, t), dot(i.toRelative1.xyz, t), dot(i.toRelative2.xyz, t));
}
#endif
