#version 450
#include "cssm1/samples.glsl"
