#version 450
// Runs once a sample: colours are of a fragment, not of a sample, so each sample needs its own.
#define LIGHT_INPUT sample in
#include "cssm2/translucent.glsl"

void main() { writeDepths(uint(gl_SampleID)); }
