// The visibility buffer (decision D10): the technique's bare answer for one light, at one layer of
// surfaces.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/transform.glsl"
#include "common/material.glsl"
#include "common/receiver.glsl"
#include <technique/visibility.glsl>
#include "common/surface.glsl"
#include "common/visibility_layer.glsl"
layout(location = 0) out vec4 o_visibility;

void main() {
  Receiver r = surfaceReceiver(v_position);
  discardUnlessInLayer(opticsAt(material, baseColorAt(material, v_uv, v_color), v_uv).alpha);
  o_visibility = vec4(lightVisibility(PASS_LIGHT, r), 1);
}
