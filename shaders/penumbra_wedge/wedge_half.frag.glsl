#version 450
// Shares in closed form.
#include "penumbra_wedge/wedge_half_share.glsl"
