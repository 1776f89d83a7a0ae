// Puts a fragment at the head of its pixel's list. Nodes come from a counter; beyond the pool the
// counter goes on, so that what was dropped is known, and nothing is written.
#include "common/layer_depth.glsl"
#include "common/opaque_test.glsl"
#include "linked_lists/nodes.glsl"
layout(early_fragment_tests) in;
layout(binding = SLOT_STORAGE(STORAGE_TRANSPARENCY), std430) buffer HeadBlock { uint heads[]; };
layout(binding = SLOT_STORAGE(STORAGE_TRANSPARENCY + 1), std430) buffer NodeBlock { uint nodes[]; };
layout(binding = SLOT_STORAGE(STORAGE_TRANSPARENCY + 2), std430) buffer CounterBlock { uint asked; };

// END_OF_LIST: the pool is full.
uint claimNode() {
  uint node = atomicAdd(asked, 1u);
  // The first test keeps indices from wrapping around.
  return node >= uint(nodes.length()) / nodeWords() || gl_HelperInvocation ? END_OF_LIST : node;
}

// The colour stands in its words by now.
void linkNode(uint node) {
  uint at = node * nodeWords();
  nodes[at] = floatBitsToUint(layerDepth());
  nodes[at + 1u] = currentSurfaceKey();
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  nodes[at + 2u] = atomicExchange(heads[pixel.y * frame.counts.y + pixel.x], node);
}
