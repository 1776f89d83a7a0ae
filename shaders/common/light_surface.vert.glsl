#version 450
#define LIGHT_OUTPUT out
#include "common/light_surface.glsl"
