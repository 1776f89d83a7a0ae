#version 450
// Runs once a sample: colours are of a fragment, not of a sample, so each sample needs its own.
#include "cssm2/translucent.glsl"

void main() { writeDepths(uint(gl_SampleID)); }
