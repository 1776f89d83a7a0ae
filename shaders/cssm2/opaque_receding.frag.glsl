#version 450
#define LIGHT_INPUT in
#define RECEDES
#include "cssm2/opaque.glsl"
