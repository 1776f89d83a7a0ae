#version 450
#define RECEDES
#include "stochastic_shadow_map/translucent.glsl"
