#version 450
// For each technique: the body has #include <technique/visibility.glsl>. Of scenes in which surfaces
// lie over others in one plane; only then are depths written.
#define WRITES_DEPTH
#include "templates/visibility_body.glsl"
