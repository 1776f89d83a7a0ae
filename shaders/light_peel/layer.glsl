// One layer: the nearest surface behind the previous layer, and what passes all up to it.
#include "light_peel/peel.glsl"
#include "common/caster_depth.glsl"
layout(constant_id = 16) const bool kFirst = true;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2DArray t_previousDepth;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 2)) uniform sampler2DArray t_previousColour;
layout(location = 0) out vec4 o_colour;

void main() {
  float depth = storeDepth();
  vec3 passes = peelFragment();
  ivec3 texel = ivec3(gl_FragCoord.xy, 0);
  if (!kFirst) {
    if (depth >= texelFetch(t_previousDepth, texel, 0).r) discard;
    passes *= texelFetch(t_previousColour, texel, 0).rgb;
  }
  o_colour = vec4(passes, 1);
}
