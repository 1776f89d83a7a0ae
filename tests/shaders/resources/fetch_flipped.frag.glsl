#version 450
// Reads the opposite texel, so that an unfinished attachment shows.
layout(binding = 24) uniform usampler2D tex;
layout(location = 0) out uint color;
void main() {
  ivec2 size = textureSize(tex, 0);
  color = texelFetch(tex, size - 1 - ivec2(gl_FragCoord.xy), 0).r + 1u;
}
