#version 450
layout(local_size_x = 1) in;
layout(binding = 56, r32ui) uniform uimage2D image;
void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  imageStore(image, p, uvec4(p.y * 1000 + p.x));
}
