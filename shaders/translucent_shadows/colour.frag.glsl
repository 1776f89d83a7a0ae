#version 450
// The colour that light keeps behind one translucent surface, for blending with the surfaces before
// and behind it. VARIANT_ENERGY is what passes: not met, or met and transmitted. The other three are
// the published way and two readings of Modisett 2023 (spec 02).
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
layout(constant_id = 16) const uint kVariant = 0u;
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;
layout(location = 0) out vec4 o_colour;

#define VARIANT_ENERGY 0u
#define VARIANT_PUBLISHED 1u
#define VARIANT_SEED_BLEND 2u
#define VARIANT_SEED_PRODUCT 3u

void main() {
  vec4 base = baseColorAt(material, v_uv, v_color);
  OpticsData o = opticsAt(material, base, v_uv);
  if (o.alpha < 1.0 / 512.0) discard;
  vec3 colour = vec3(1) - o.alpha * (vec3(1) - o.t);
  if (kVariant == VARIANT_PUBLISHED) colour = clamp(base.rgb, 0.0, 1.0);
  if (kVariant == VARIANT_SEED_BLEND || kVariant == VARIANT_SEED_PRODUCT)
    colour = (1.0 - o.alpha) * o.t;
  o_colour = vec4(colour, o.alpha);
}
