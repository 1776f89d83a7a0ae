#version 450
// Camera-relative position of a layer's surface, from its depth alone; 0 where there is none.
#include "common/scene.glsl"
#include "common/position.glsl"
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2D t_depth;
layout(location = 0) out vec4 o_answer;

void main() {
  float depth = texelFetch(t_depth, ivec2(gl_FragCoord.xy), 0).r;
  o_answer = depth == 0.0 ? vec4(0) : vec4(positionOfDepth(gl_FragCoord.xy, depth), 1);
}
