// A node with the light of a fragment and its weight of what lies behind.
#define EMITS_WEIGHTS
#include "linked_lists/append.glsl"

bool beginFragment(OpticsData optics) { return !gl_HelperInvocation && !behindOpaque(); }

void emitFragment(vec3 light, vec3 behind) {
  uint node = claimNode();
  if (node == END_OF_LIST) return;
  uint at = node * nodeWords();
  if (kHalfColours) {
    light = min(light, vec3(65504.0));
    nodes[at + 3u] = packHalf2x16(light.rg);
    nodes[at + 4u] = packHalf2x16(vec2(light.b, behind.r));
    nodes[at + 5u] = packHalf2x16(behind.gb);
  } else {
    nodes[at + 3u] = packUnorm4x8(vec4(light, 0));
    nodes[at + 4u] = packUnorm4x8(vec4(behind, 0));
  }
  linkNode(node);
}
