#version 450
#define RECEDES
#include "translucent_shadows/depth.glsl"
