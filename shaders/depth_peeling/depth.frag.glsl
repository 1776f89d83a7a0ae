#version 450
#include "depth_peeling/depth.glsl"
