#define WALKS avx2Walks
#include "suites/truth/box_walk_kernel.h"
