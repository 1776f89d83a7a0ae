#version 450
// Of scenes in which surfaces lie over others in one plane.
#define WRITES_DEPTH
#include "common/visibility_depth.glsl"
