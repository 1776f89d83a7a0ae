#define WALK walkAvx2
#include "suites/truth/box_walk_kernel.h"
