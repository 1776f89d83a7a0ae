// One step inward from both sides. The fragment at the near bound goes under the front layers, the
// one at the far bound over the back layers; those between vote for the next bounds and are not
// shaded. Bounds are (-near, far), MAX blended; (-2, -2) says that nothing is left: no depth lies
// between 2 and -2.
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 1)) uniform sampler2D t_bounds;
layout(location = 0) out vec2 o_bounds;
layout(location = 1) out vec4 o_front;
layout(location = 2) out vec4 o_back;

bool g_isFront;

bool beginFragment(float alpha) {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = gl_FragCoord.z;
  if (depth > texelFetch(t_opaqueDepth, pixel, 0).r) discard;
  vec2 bounds = texelFetch(t_bounds, pixel, 0).rg;
  float near = -bounds.x, far = bounds.y;
  if (depth < near || depth > far) discard;
  // What is not written below leaves both sides as they are: colour 0, opacity 0.
  o_front = vec4(0);
  o_back = vec4(0);
  if (depth > near && depth < far) {
    o_bounds = vec2(-depth, depth);
    return false;
  }
  o_bounds = vec2(-2);
  // The middle one of an odd number is at both bounds: front, and only once.
  g_isFront = depth == near;
  return true;
}

void emitFragment(vec3 radiance, float alpha) {
  vec4 color = vec4(radiance * alpha, alpha);
  if (g_isFront)
    o_front = color;
  else
    o_back = color;
}
