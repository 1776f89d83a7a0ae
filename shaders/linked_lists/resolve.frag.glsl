#version 450
// Sorts each pixel's list and composes it over the picture.
#include "linked_lists/sort.glsl"
layout(location = 0) out vec4 o_color;

vec4 colourOf(uint at) {
  if (!kHalfColours) return unpackUnorm4x8(nodes[at + 3u]);
  return vec4(unpackHalf2x16(nodes[at + 3u]), unpackHalf2x16(nodes[at + 4u]));
}

// The layers that found no place, mixed by weight alone: 64-bit sums in units of 2^-16 of a colour
// that is at most 65504, and of the logarithm of the transmittance.
uvec4 tailLow, tailHigh;
uint tailLog;

void clearTail() {
  tailLow = uvec4(0);
  tailHigh = uvec4(0);
  tailLog = 0u;
}

void addToTail(uint at) {
  vec4 color = colourOf(at);
  uvec4 carry;
  tailLow = uaddCarry(tailLow, uvec4(color * 65536.0), carry);
  tailHigh += carry;
  float density = color.a < 1.0 ? min(-log2(1.0 - color.a), 32.0) : 32.0;
  tailLog = min(tailLog + uint(density * 65536.0), 0x40000000u);
}

void main() {
  // Return, not discard: lanes without coverage read zeros and would walk from node 0 to node 0.
  if (gl_HelperInvocation) return;
  clearTail();
  uint count = sortList();
  if (count == 0u) discard;
  vec3 color = vec3(0);
  float through = 1.0;
  for (uint i = 0u; i < count; ++i) {
    vec4 layer = colourOf(words[i]);
    color += through * layer.rgb;
    through *= 1.0 - layer.a;
  }
  vec4 sum = vec4(tailHigh) * 65536.0 + vec4(tailLow) * (1.0 / 65536.0);
  if (sum.a > 0.0) {
    float tailThrough = exp2(-float(tailLog) * (1.0 / 65536.0));
    color += through * (1.0 - tailThrough) * sum.rgb / sum.a;
    through *= tailThrough;
  }
  o_color = vec4(color, through);
}
