// A driver that fails within a hard case: a failure, unless the device declares the lack.
#include <gtest/gtest.h>

#include "backends/null/null_backend.h"
#include "backends/rhi/memory_limit.h"
#include "suites/harness/devices.h"
#include "suites/stability/stability.h"

namespace shadowbench_shader_blob {
void addTo(rhi::ShaderLibrary& library);
}

namespace sb {
namespace {

struct Faults : rhi::Observer {
  std::string code;
  void beginPass(const rhi::PassDesc&) override {
    if (!code.empty()) throw rhi::Error("vkCall", code, "for this test");
  }
};

TEST(StabilityFaults, OnlyWhatTheDeviceDeclaresIsASkip) {
  rhi::ShaderLibrary shaders;
  shadowbench_shader_blob::addTo(shaders);
  Faults faults;
  auto backend = null_backend::makeBackend();
  auto device = backend->open({});
  device->setObserver(&faults);
  PipelineCache pipelines(*device);
  FrameQueries queries(*device);
  const DeviceContext context{*device, shaders, pipelines, queries};
  const StabilityJob job{"G1", "ShadowMap", "Sorted", "null", {}, 1};
  const auto verdict = [&](const std::string& code) {
    faults.code = code;
    const report::StabilityRecord r = runStability(job, context, nullptr, true);
    EXPECT_NE(r.why.find("for this test"), std::string::npos) << r.why;
    return r.verdict;
  };
  using report::Verdict;
  EXPECT_EQ(verdict("VK_ERROR_UNKNOWN"), Verdict::Fail);
  EXPECT_EQ(verdict("GL_INVALID_OPERATION"), Verdict::Fail);
  EXPECT_EQ(verdict("VK_ERROR_INITIALIZATION_FAILED"), Verdict::Fail);
  EXPECT_EQ(verdict("VK_ERROR_FORMAT_NOT_SUPPORTED"), Verdict::Skipped);
  EXPECT_EQ(verdict("VK_ERROR_FEATURE_NOT_PRESENT"), Verdict::Skipped);
  EXPECT_EQ(verdict(rhi::kTooLarge), Verdict::Skipped);
  EXPECT_EQ(verdict("GL_OUT_OF_MEMORY"), Verdict::Skipped);
  faults.code = "VK_ERROR_DEVICE_LOST";
  EXPECT_THROW(runStability(job, context, nullptr, true), rhi::Error);
  EXPECT_EQ(failedStability(job, "gone").verdict, Verdict::Fail);
}

}  // namespace
}  // namespace sb
