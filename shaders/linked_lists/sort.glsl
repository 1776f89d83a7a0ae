// A pixel's list in the order of (depth, key of the surface). The order of nodes in a list varies
// from run to run; nothing here depends on it: the kLayers nearest are a set, their order is strict,
// and sums over the others are of integers. The including shader has addToTail(node's first word),
// which gets the others.
#include "common/shared_slots.h"
#include "common/shared_types.h"
#include "linked_lists/nodes.glsl"
layout(constant_id = 33) const uint kLayers = 16u;
layout(binding = SLOT_UNIFORM(UNIFORM_FRAME), std140) uniform FrameBlock { FrameData frame; };

// Nearest first, of the greatest depth. Depths are not negative: their bits order as they do.
uint depths[kLayers], keys[kLayers], words[kLayers];

void addToTail(uint at);

// How many of the arrays are filled.
uint sortList() {
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  uint node = heads[pixel.y * frame.counts.y + pixel.x];
  uint capacity = listCapacity();
  uint count = 0u;
  for (uint i = 0u; i < capacity && node < capacity; ++i) {
    uint at = node * nodeWords();
    uint depth = nodes[at], key = nodes[at + 1u];
    uint place = count;
    while (place > 0u && (depth > depths[place - 1u] ||
                          (depth == depths[place - 1u] && key < keys[place - 1u])))
      --place;
    if (place >= kLayers) {
      addToTail(at);
    } else {
      if (count == kLayers)
        addToTail(words[kLayers - 1u]);
      else
        ++count;
      for (uint j = count - 1u; j > place; --j) {
        depths[j] = depths[j - 1u];
        keys[j] = keys[j - 1u];
        words[j] = words[j - 1u];
      }
      depths[place] = depth;
      keys[place] = key;
      words[place] = at;
    }
    node = nodes[at + 2u];
  }
  return count;
}
