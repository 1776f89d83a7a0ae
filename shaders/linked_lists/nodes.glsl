// A node of a pixel's list: depth, key of the surface, next node, and its premultiplied colour in
// one word (8 bits a channel) or two (half floats).
layout(constant_id = 32) const bool kHalfColours = true;
#define END_OF_LIST 0xFFFFFFFFu

uint nodeWords() { return kHalfColours ? 5u : 4u; }
