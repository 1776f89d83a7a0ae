// Lists in a pool of nodes (techniques/lists/list_pool.h). Defined before: LIST_STORAGE, the first of
// its three storage slots; uint nodeWords(), words of a node; LIST_BUILDS where lists are filled.
#include "common/shared_lists.h"
#ifdef LIST_BUILDS
#define LIST_ACCESS
#else
#define LIST_ACCESS readonly
#endif
layout(binding = SLOT_STORAGE(LIST_STORAGE), std430) LIST_ACCESS buffer HeadBlock { uint heads[]; };
layout(binding = SLOT_STORAGE(LIST_STORAGE + 1), std430) LIST_ACCESS buffer NodeBlock {
  uint nodes[];
};

uint listCapacity() { return uint(nodes.length()) / nodeWords(); }

#ifdef LIST_BUILDS
layout(binding = SLOT_STORAGE(LIST_STORAGE + 2), std430) buffer CounterBlock { uint asked; };

// END_OF_LIST: the pool is full. Beyond it the counter goes on, so that what was dropped is known.
// Not for helper invocations, whose atomics give anything.
uint claimNode() {
  uint node = atomicAdd(asked, 1u);
  return node >= listCapacity() ? END_OF_LIST : node;
}

// Puts a node at the head of a list; what stood there follows it.
uint pushNode(uint list, uint node) { return atomicExchange(heads[list], node); }
#endif
