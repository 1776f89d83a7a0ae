#define WALKS baselineWalks
#include "suites/truth/box_walk_kernel.h"
