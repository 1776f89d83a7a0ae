#version 450
// Shares from the source's tables.
#define COVERAGE_TABLES
#include "penumbra_wedge/wedge_loop_share.glsl"
