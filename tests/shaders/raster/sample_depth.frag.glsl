#version 450
layout(binding = 24) uniform sampler2D depth;
layout(location = 0) in vec4 vertexColor;
layout(location = 0) out vec4 color;
void main() { color = vertexColor * texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r; }
