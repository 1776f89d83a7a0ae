#version 450
layout(binding = 24) uniform sampler2DMS samples;
layout(location = 0) in vec4 vertexColor;
layout(location = 0) out vec4 color;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  color = vec4(texelFetch(samples, at, 0).r, texelFetch(samples, at, 1).r,
               texelFetch(samples, at, 2).r, texelFetch(samples, at, 3).r) * vertexColor;
}
