#version 450
// Runs once a sample: each has a depth of its own, and the channels hold it.
#define LIGHT_INPUT sample in
#include "cssm2/opaque.glsl"
