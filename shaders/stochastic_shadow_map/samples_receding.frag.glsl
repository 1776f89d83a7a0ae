#version 450
#define RECEDES
#include "stochastic_shadow_map/samples.glsl"
