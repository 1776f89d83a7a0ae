#version 450
#include "translucent_shadows/depth.glsl"
