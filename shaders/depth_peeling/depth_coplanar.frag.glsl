#version 450
// Where surfaces lie over others in one plane.
#define WRITES_DEPTH
#include "depth_peeling/depth.glsl"
