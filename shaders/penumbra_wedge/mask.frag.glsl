#version 450
// Shares in closed form.
#include "penumbra_wedge/mask_share.glsl"
