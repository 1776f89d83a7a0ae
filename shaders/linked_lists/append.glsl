// Puts a fragment at the head of its pixel's list.
#include "common/layer_depth.glsl"
#include "common/opaque_test.glsl"
#define LIST_BUILDS
#include "linked_lists/nodes.glsl"
layout(early_fragment_tests) in;

// The colour stands in its words by now.
void linkNode(uint node) {
  uint at = node * nodeWords();
  nodes[at] = floatBitsToUint(layerDepth());
  nodes[at + 1u] = currentSurfaceKey();
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  nodes[at + 2u] = pushNode(pixel.y * frame.counts.y + pixel.x, node);
}
