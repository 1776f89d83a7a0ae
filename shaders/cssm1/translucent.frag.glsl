#version 450
#include "cssm1/translucent.glsl"
