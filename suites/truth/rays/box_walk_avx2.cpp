#define WALKS avx2Walks
#include "suites/truth/rays/box_walk_kernel.h"
