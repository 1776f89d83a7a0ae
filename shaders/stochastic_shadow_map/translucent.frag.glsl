#version 450
#include "stochastic_shadow_map/translucent.glsl"
