// Cells on the shared devices of the GPU tests.
#pragma once

#include "tests/gpu_test.h"
#include "tests/techniques/cell.h"

namespace sb::test {

/// Pipelines and queries of a shared device, closed with it.
inline CellDevice& cellDevice(rhi::Device& device) {
  static std::map<const rhi::Device*, CellDevice*> known;
  auto [it, isNew] = known.try_emplace(&device);
  if (isNew) {
    auto made = std::make_shared<CellDevice>(device);
    it->second = made.get();
    keepWithDevice(device, std::move(made));
  }
  return *it->second;
}

}  // namespace sb::test
