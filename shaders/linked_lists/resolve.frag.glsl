#version 450
// Sorts each pixel's list by (depth, key of the surface) and composes it over the picture. The order
// of nodes in a list varies from run to run; nothing here depends on it: the kLayers nearest are a
// set, their order is strict, and sums over the others are of integers.
#include "common/shared_slots.h"
#include "common/shared_types.h"
#include "linked_lists/nodes.glsl"
layout(constant_id = 33) const uint kLayers = 16u;
layout(binding = SLOT_UNIFORM(UNIFORM_FRAME), std140) uniform FrameBlock { FrameData frame; };
layout(binding = SLOT_STORAGE(STORAGE_TRANSPARENCY), std430) readonly buffer HeadBlock {
  uint heads[];
};
layout(binding = SLOT_STORAGE(STORAGE_TRANSPARENCY + 1), std430) readonly buffer NodeBlock {
  uint nodes[];
};
layout(location = 0) out vec4 o_color;

// Nearest first. Depths are not negative: their bits order as they do.
uint depths[kLayers], keys[kLayers], words[kLayers];

vec4 colourOf(uint at) {
  if (!kHalfColours) return unpackUnorm4x8(nodes[at + 3u]);
  return vec4(unpackHalf2x16(nodes[at + 3u]), unpackHalf2x16(nodes[at + 4u]));
}

// The layers that found no place, mixed by weight alone: 64-bit sums in units of 2^-16 of a colour
// that is at most 65504, and of the logarithm of the transmittance.
struct Tail {
  uvec4 low, high;
  uint log;
};

void addToTail(inout Tail tail, vec4 color) {
  uvec4 carry;
  tail.low = uaddCarry(tail.low, uvec4(color * 65536.0), carry);
  tail.high += carry;
  float density = color.a < 1.0 ? min(-log2(1.0 - color.a), 32.0) : 32.0;
  tail.log = min(tail.log + uint(density * 65536.0), 0x40000000u);
}

void main() {
  // Return, not discard: lanes without coverage read zeros and would walk from node 0 to node 0.
  if (gl_HelperInvocation) return;
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  uint node = heads[pixel.y * frame.counts.y + pixel.x];
  if (node == END_OF_LIST) discard;
  uint capacity = uint(nodes.length()) / nodeWords();
  uint count = 0u;
  Tail tail = Tail(uvec4(0), uvec4(0), 0u);
  for (uint i = 0u; i < capacity && node < capacity; ++i) {
    uint at = node * nodeWords();
    uint depth = nodes[at], key = nodes[at + 1u];
    uint place = count;
    while (place > 0u && (depth < depths[place - 1u] ||
                          (depth == depths[place - 1u] && key < keys[place - 1u])))
      --place;
    if (place >= kLayers) {
      addToTail(tail, colourOf(at));
    } else {
      if (count == kLayers)
        addToTail(tail, colourOf(words[kLayers - 1u]));
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
  vec3 color = vec3(0);
  float through = 1.0;
  for (uint i = 0u; i < count; ++i) {
    vec4 layer = colourOf(words[i]);
    color += through * layer.rgb;
    through *= 1.0 - layer.a;
  }
  vec4 sum = vec4(tail.high) * 65536.0 + vec4(tail.low) * (1.0 / 65536.0);
  if (sum.a > 0.0) {
    float tailThrough = exp2(-float(tail.log) * (1.0 / 65536.0));
    color += through * (1.0 - tailThrough) * sum.rgb / sum.a;
    through *= tailThrough;
  }
  o_color = vec4(color, through);
}
