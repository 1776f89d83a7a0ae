// A node with the premultiplied colour of a fragment.
#include "linked_lists/append.glsl"

bool beginFragment(float alpha) { return !gl_HelperInvocation && !behindOpaque(); }

void emitFragment(vec3 radiance, float alpha) {
  uint node = claimNode();
  if (node == END_OF_LIST) return;
  vec4 color = vec4(radiance * alpha, alpha);
  uint at = node * nodeWords();
  if (kHalfColours) {
    nodes[at + 3u] = packHalf2x16(min(color.rg, vec2(65504.0)));
    nodes[at + 4u] = packHalf2x16(min(color.ba, vec2(65504.0)));
  } else {
    nodes[at + 3u] = packUnorm4x8(color);
  }
  linkNode(node);
}
