// A node of a pixel's list: depth, key of the surface, next node, and its premultiplied colour in
// one word (8 bits a channel) or two (half floats); with a weight per channel of what lies behind
// (EMITS_WEIGHTS) one word more.
layout(constant_id = 32) const bool kHalfColours = true;

#ifdef EMITS_WEIGHTS
uint nodeWords() { return kHalfColours ? 6u : 5u; }
#else
uint nodeWords() { return kHalfColours ? 5u : 4u; }
#endif
#define LIST_STORAGE STORAGE_TRANSPARENCY
#include "common/list_pool.glsl"
