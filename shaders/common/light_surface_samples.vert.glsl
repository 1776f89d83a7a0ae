#version 450
// For fragment shaders that run once a sample: OpenGL wants both sides to say so.
#define LIGHT_OUTPUT sample out
#include "common/light_surface.glsl"
