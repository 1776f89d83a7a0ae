// One test, every backend: GPU_TEST(Suite, Name) { ... } expands to a test per backend, whose body
// sees `device()`. All tests of a backend in a process share one device (and so its pipelines; the
// first draw of each costs 0.4 s on software drivers). A driver that does not start is a skip,
// unless SHADOWBENCH_REQUIRE names its backend ("vulkan,opengl,opengl-osmesa"): then it is a
// failure. After each test, any message of the driver's validation or of the RHI's own fails it.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "backends/rhi/device.h"

namespace sb::test {

/// "vulkan", "opengl", "opengl-osmesa".
const std::vector<std::string>& gpuBackends();

/// The process's device of a backend, opened with validation on first use; null when its driver
/// does not start (`why` then says so).
rhi::Device* sharedDevice(const std::string& backend, std::string* why = nullptr);

/// Keeps an object that lives on a shared device (pipelines, query pools) until the device closes.
void keepWithDevice(const rhi::Device& device, std::shared_ptr<void> object);

/// Shaders below tests/shaders.
const rhi::ShaderLibrary& testShaders();

class GpuTest : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override;
  void TearDown() override;
  rhi::Device& device() { return *m_device; }
  const std::string& backend() const { return GetParam(); }
  /// Messages that this test provokes on purpose are taken with device().takeMessages().
  rhi::Device* m_device = nullptr;
};

}  // namespace sb::test

#define GPU_TEST(Suite, Name)                                                                 \
  class Suite##_##Name : public sb::test::GpuTest {                                           \
   public:                                                                                    \
    void body();                                                                              \
  };                                                                                          \
  TEST_P(Suite##_##Name, runs) { body(); }                                                    \
  INSTANTIATE_TEST_SUITE_P(Suite, Suite##_##Name, testing::ValuesIn(sb::test::gpuBackends()), \
                           [](const auto& info) {                                             \
                             std::string name = info.param;                                   \
                             for (char& c : name) c = c == '-' ? '_' : c;                     \
                             return name;                                                     \
                           });                                                                \
  void Suite##_##Name::body()
