#define WALK walkBaseline
#include "suites/truth/box_walk_kernel.h"
