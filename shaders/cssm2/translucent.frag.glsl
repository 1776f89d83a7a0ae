#version 450
#include "cssm2/translucent.glsl"

void main() { writeDepths(0u); }
