#version 450
// Sets one of 128 bits per instance, in four image layers and in a buffer alike.
layout(binding = 8, std430) buffer Masks { uint words[]; };
layout(binding = 56, r32ui) uniform uimage2DArray layers;
layout(binding = 0, std140) uniform Size { uint width; };
layout(location = 1) flat in uint instance;
void main() {
  if (gl_HelperInvocation) return;
  ivec2 p = ivec2(gl_FragCoord.xy);
  if ((uint(p.x) + instance) % 3u == 0u) return;
  uint word = instance / 32u, bit = 1u << (instance % 32u);
  imageAtomicOr(layers, ivec3(p, int(word)), bit);
  atomicOr(words[(uint(p.y) * width + uint(p.x)) * 4u + word], bit);
}
