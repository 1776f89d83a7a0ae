#version 450
layout(local_size_x = 1) in;
layout(binding = 56, rgba32f) uniform image2DArray image;
void main() {
  ivec3 p = ivec3(gl_GlobalInvocationID);
  imageStore(image, p, imageLoad(image, p) + vec4(p, 1));
}
