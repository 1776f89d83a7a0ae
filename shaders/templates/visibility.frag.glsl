#version 450
// For each technique: the body has #include <technique/visibility.glsl>.
#include "templates/visibility_body.glsl"
