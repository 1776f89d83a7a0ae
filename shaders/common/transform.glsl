#ifndef TRANSFORM_GLSL
#define TRANSFORM_GLSL
// Positions, in arithmetic that every API must keep (decision D1): sums written out and `precise`.
vec3 toRelative(vec4 row0, vec4 row1, vec4 row2, vec3 p) {
  precise vec3 r;
  r.x = row0.x * p.x + row0.y * p.y + row0.z * p.z + row0.w;
  r.y = row1.x * p.x + row1.y * p.y + row1.z * p.z + row1.w;
  r.z = row2.x * p.x + row2.y * p.y + row2.z * p.z + row2.w;
  return r;
}

vec4 toClip(mat4 m, vec3 p) {
  precise vec4 c = m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
  return c;
}

// A direction through rows of a matrix: a normal through the cofactors of an instance.
vec3 throughRows(vec3 row0, vec3 row1, vec3 row2, vec3 v) {
  return vec3(dot(row0, v), dot(row1, v), dot(row2, v));
}
#endif
