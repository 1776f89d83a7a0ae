#version 450
// Counts fragments in a buffer and, per pixel, in an image. Without the guard, helper lanes would
// count too.
layout(binding = 8, std430) buffer Totals { uint count; uint greatest; uint parity; };
layout(binding = 56, r32ui) uniform uimage2D perPixel;
layout(location = 1) flat in uint instance;
void main() {
  if (gl_HelperInvocation) return;
  ivec2 p = ivec2(gl_FragCoord.xy);
  atomicAdd(count, 1u);
  atomicMax(greatest, uint(p.y * 1000 + p.x));
  atomicXor(parity, uint(p.y * 1000 + p.x) * 2654435761u);
  imageAtomicAdd(perPixel, p, 1u + instance);
}
