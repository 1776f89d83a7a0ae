// What was computed for the layer at hand (tests/techniques/layer_probe.h).
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2D t_answer;
vec3 lightVisibility(uint light, Receiver r) {
  return texelFetch(t_answer, ivec2(r.pixel), 0).rgb;
}
