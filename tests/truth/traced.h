#pragma once

#include <gtest/gtest.h>

#include "suites/truth/tracer.h"

namespace sb::test {

inline Truth traced(const Scene& scene, uint32_t size = 64, unsigned threads = 0) {
  return *Tracer(scene, size, size, threads).trace({.width = size, .height = size});
}

inline void expectNear(const glm::dvec3& found, const glm::dvec3& expected, double tolerance,
                       const char* what = "channel") {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], tolerance) << what << " " << c;
}

}  // namespace sb::test
