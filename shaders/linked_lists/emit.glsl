// Puts a fragment at the head of its pixel's list. Nodes come from a counter; beyond the pool the
// counter goes on, so that what was dropped is known, and nothing is written.
#include "linked_lists/nodes.glsl"
layout(early_fragment_tests) in;
layout(binding = SLOT_STORAGE(STORAGE_TRANSPARENCY), std430) buffer HeadBlock { uint heads[]; };
layout(binding = SLOT_STORAGE(STORAGE_TRANSPARENCY + 1), std430) buffer NodeBlock { uint nodes[]; };
layout(binding = SLOT_STORAGE(STORAGE_TRANSPARENCY + 2), std430) buffer CounterBlock { uint asked; };

bool beginFragment(float alpha) { return !gl_HelperInvocation; }

void emitFragment(vec3 radiance, float alpha) {
  uint node = atomicAdd(asked, 1u);
  uint at = node * nodeWords();
  // The first test keeps `at` from wrapping around.
  if (node >= uint(nodes.length()) / nodeWords() || gl_HelperInvocation) return;
  vec4 color = vec4(radiance * alpha, alpha);
  nodes[at] = floatBitsToUint(gl_FragCoord.z);
  nodes[at + 1u] = currentSurfaceKey(instances[draw.ids.x]);
  if (kHalfColours) {
    nodes[at + 3u] = packHalf2x16(min(color.rg, vec2(65504.0)));
    nodes[at + 4u] = packHalf2x16(min(color.ba, vec2(65504.0)));
  } else {
    nodes[at + 3u] = packUnorm4x8(color);
  }
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  nodes[at + 2u] = atomicExchange(heads[pixel.y * frame.counts.y + pixel.x], node);
}
