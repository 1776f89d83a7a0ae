#version 450
// A caster as the light sees it: position only.
#include "common/scene.glsl"
#include "common/transform.glsl"
#include "common/light_pass.glsl"
layout(location = 0) in vec3 a_position;

void main() { gl_Position = toLightClip(toRelative(instances[draw.ids.x], a_position)); }
