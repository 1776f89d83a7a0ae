#version 450
#define RECEDES
#include "light_peel/layer.glsl"
