// One frame of a technique on the null backend, as it was called.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "backends/null/null_backend.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "tests/techniques/cell.h"

namespace sb::test {

using null_backend::Call;
using null_backend::CallKind;

struct Recorded {
  std::vector<Call> calls;  ///< of one frame
  FrameResult frame;
  std::map<std::string, uint64_t> bytes;
  Plan plan;
  size_t pipelines = 0;
};

inline Recorded record(const Scene& scene, const std::string& technique,
                std::map<std::string, std::string> knobs = {},
                const std::string& transparency = "Sorted") {
  const auto device = null_backend::makeBackend()->open({});
  Recorded r;
  {
    CellDevice shared(*device);
    Cell cell(shared, scene, {.technique = technique,
                               .knobs = std::move(knobs),
                               .transparency = transparency});
    null_backend::clearCalls(*device);
    cell.renderAgain();
    r = {null_backend::calls(*device), cell.result(), cell.renderer().bytesByLabel(),
         cell.renderer().plan(), shared.pipelines.size()};
  }
  EXPECT_TRUE(device->takeMessages().empty());
  return r;
}

inline Scene opaqueScene() {
  Scene scene = floorScene();
  scene.cameras[0] = lookAt({2, 3, 4}, {0, 0, 0});
  addBox(scene, 0, {-1, 0.25f, -1}, {0, 1, 0});
  return scene;
}

inline Scene withPane(Scene scene) {
  addHorizontal(scene, add(scene, glass(0.5f, {1, 0.5f, 0.25f})), {0, 1.5f, 0}, 0.5f, 0.5f);
  return scene;
}

inline std::vector<std::string> passes(const Recorded& r) {
  std::vector<std::string> labels;
  for (const PassResult& p : r.frame.passes) labels.push_back(p.label);
  return labels;
}

/// Meshes that a pass draws, whichever of them are one call.
inline uint64_t draws(const Recorded& r, const std::string& pass) {
  uint64_t count = 0;
  for (const PassResult& p : r.frame.passes)
    if (p.label == pass) count += p.counters.draws;
  return count;
}

/// Calls without the names of pipelines, which differ between techniques.
inline std::vector<Call> anonymous(std::vector<Call> calls) {
  for (Call& c : calls) c.pipeline.clear();
  return calls;
}

}  // namespace sb::test
