#version 450
#define LIGHT_INPUT sample in
#define RECEDES
#include "cssm2/opaque.glsl"
