#version 450
// As without colours, with a transmittance per channel; over the picture from two sources.
#define EMITS_WEIGHTS
#include "linked_lists/sort.glsl"
layout(location = 0, index = 0) out vec4 o_color;
layout(location = 0, index = 1) out vec4 o_behind;

struct Layer {
  vec3 light, behind;
};

Layer layerAt(uint at) {
  if (!kHalfColours)
    return Layer(unpackUnorm4x8(nodes[at + 3u]).rgb, unpackUnorm4x8(nodes[at + 4u]).rgb);
  vec2 mixed = unpackHalf2x16(nodes[at + 4u]);
  return Layer(vec3(unpackHalf2x16(nodes[at + 3u]), mixed.x),
               vec3(mixed.y, unpackHalf2x16(nodes[at + 5u])));
}

// The layers that found no place, mixed by what they hide: 64-bit sums in units of 2^-16 of light
// and of 1 - weight, and of the logarithms of the weights.
uvec3 lightLow, lightHigh, hidesLow, hidesHigh, tailLog;

void clearTail() {
  lightLow = uvec3(0);
  lightHigh = uvec3(0);
  hidesLow = uvec3(0);
  hidesHigh = uvec3(0);
  tailLog = uvec3(0);
}

void addToTail(uint at) {
  Layer layer = layerAt(at);
  uvec3 carry;
  lightLow = uaddCarry(lightLow, uvec3(layer.light * 65536.0), carry);
  lightHigh += carry;
  hidesLow = uaddCarry(hidesLow, uvec3((1.0 - layer.behind) * 65536.0), carry);
  hidesHigh += carry;
  vec3 density = min(-log2(max(layer.behind, vec3(1.0 / 4294967296.0))), vec3(32.0));
  tailLog = min(tailLog + uvec3(density * 65536.0), uvec3(0x40000000u));
}

vec3 sumOf(uvec3 low, uvec3 high) { return vec3(high) * 65536.0 + vec3(low) * (1.0 / 65536.0); }

void main() {
  // Return, not discard: lanes without coverage read zeros and would walk from node 0 to node 0.
  if (gl_HelperInvocation) return;
  clearTail();
  uint count = sortList();
  if (count == 0u) discard;
  vec3 color = vec3(0), through = vec3(1);
  for (uint i = 0u; i < count; ++i) {
    Layer layer = layerAt(words[i]);
    color += through * layer.light;
    through *= layer.behind;
  }
  vec3 tailThrough = exp2(-vec3(tailLog) * (1.0 / 65536.0));
  vec3 hides = sumOf(hidesLow, hidesHigh), light = sumOf(lightLow, lightHigh);
  // What hides nothing in a channel dims no other light there.
  for (int c = 0; c < 3; ++c) {
    float scale = hides[c] > 0.0 ? (1.0 - tailThrough[c]) / hides[c] : 1.0;
    color[c] += through[c] * light[c] * scale;
  }
  through *= tailThrough;
  o_color = vec4(color, 0);
  o_behind = vec4(through, 1);
}
