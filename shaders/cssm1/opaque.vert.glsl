#version 450
#include "cssm1/layered.glsl"
layout(location = 0) in vec3 a_position;

void main() { toLayer(a_position); }
