#version 450
// Work of a known amount for the check of timers: blended, so that no draw can be left out.
layout(location = 0) out vec4 o_color;
void main() {
  float x = gl_FragCoord.x * 0.001;
  for (int i = 0; i < 24; ++i) x = x * 0.75 + sqrt(abs(x) + 0.01) * 0.1;
  o_color = vec4(x * 1e-3);
}
