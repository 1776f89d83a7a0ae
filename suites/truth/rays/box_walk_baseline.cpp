#define WALKS baselineWalks
#include "suites/truth/rays/box_walk_kernel.h"
