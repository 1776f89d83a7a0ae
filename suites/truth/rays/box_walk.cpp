#include "suites/truth/rays/box_walk.h"

namespace sb {

bool hasAvx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

const BoxWalks& bestWalks() {
  static const BoxWalks best = hasAvx2() ? avx2Walks() : baselineWalks();
  return best;
}

}  // namespace sb
