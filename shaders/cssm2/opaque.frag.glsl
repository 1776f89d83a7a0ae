#version 450
#define LIGHT_INPUT in
#include "cssm2/opaque.glsl"
