#version 450
// Everything behind the last layer, multiplied.
#include "light_peel/peel.glsl"
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2DArray t_previousDepth;
layout(location = 0) out vec4 o_colour;

void main() {
  float depth = recedingDepth();
  vec3 passes = peelFragment();
  if (depth >= texelFetch(t_previousDepth, ivec3(gl_FragCoord.xy, 0), 0).r) discard;
  o_colour = vec4(passes, 1);
}
