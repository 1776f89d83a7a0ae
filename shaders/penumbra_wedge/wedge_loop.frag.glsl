#version 450
// Shares in closed form.
#include "penumbra_wedge/wedge_loop_share.glsl"
