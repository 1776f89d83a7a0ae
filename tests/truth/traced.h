#pragma once
#include "suites/truth/tracer.h"

namespace sb::test {

inline Truth traced(const Scene& scene, uint32_t size = 64, unsigned threads = 0) {
  return *Tracer(scene, size, size, threads).trace({.width = size, .height = size});
}

}  // namespace sb::test
