// Opacity of a translucent caster for one depth: its alpha, or what it takes of the luminance of
// white light (ITU-R BT.709).
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/light_blocking.glsl"
layout(constant_id = 17) const bool kLuminance = true;

float opacity() {
  if (!kLuminance)
    return lightOptics(material, v_uv, v_color).alpha;
  vec3 p = blockingProbability();
  // In this form grey stays what it is: 0 and 1 are exact.
  return p.g + 0.2126 * (p.r - p.g) + 0.0722 * (p.b - p.g);
}
