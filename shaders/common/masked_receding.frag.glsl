#version 450
#define RECEDES
#include "common/masked.glsl"
