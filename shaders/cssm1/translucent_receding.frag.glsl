#version 450
#define RECEDES
#include "cssm1/translucent.glsl"
