#version 450
// A caster as the light sees it: position only.
#include "common/scene.glsl"
#include "common/light_pass.glsl"
#include "common/instance.glsl"
layout(location = 0) in vec3 a_position;

void main() { gl_Position = toLightClip(placeInstance(a_position)); }
