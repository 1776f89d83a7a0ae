#version 450
#include "light_peel/layer.glsl"
