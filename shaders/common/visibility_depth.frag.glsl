#version 450
#include "common/visibility_depth.glsl"
