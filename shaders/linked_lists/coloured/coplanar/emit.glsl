// Where surfaces lie over others in one plane: not before the opaque surface in whose plane it lies.
#define TESTS_OPAQUE
#include "linked_lists/coloured/emit.glsl"
