#version 450
layout(local_size_x = 1) in;
layout(binding = 56, r32f) uniform image3D image;
void main() {
  ivec3 p = ivec3(gl_GlobalInvocationID);
  imageStore(image, p, vec4(p.x + p.y * 10 + p.z * 100));
}
