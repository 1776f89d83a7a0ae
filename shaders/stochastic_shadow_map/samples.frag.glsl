#version 450
#include "stochastic_shadow_map/samples.glsl"
