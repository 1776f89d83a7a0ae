#include "suites/truth/box_walk.h"

namespace sb {

bool hasAvx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

BoxWalk bestWalk() {
  static const BoxWalk best = hasAvx2() ? walkAvx2 : walkBaseline;
  return best;
}

}  // namespace sb
