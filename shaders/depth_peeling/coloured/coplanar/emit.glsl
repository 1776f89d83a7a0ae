// Where surfaces lie over others in one plane: depths are written, so that each is a layer.
#define WRITES_DEPTH
#include "depth_peeling/coloured/emit.glsl"
