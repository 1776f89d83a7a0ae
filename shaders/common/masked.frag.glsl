#version 450
#include "common/masked.glsl"
