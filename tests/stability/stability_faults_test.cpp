// A driver that fails within a hard case: a failure, unless the device declares the lack.
#include <gtest/gtest.h>

#include "backends/null/null_backend.h"
#include "backends/rhi/memory_limit.h"
#include "suites/harness/devices.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/stability.h"
#include "techniques/render/registry.h"

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
  const StabilityJob job{.caseId = "G1", .technique = "ShadowMap", .transparency = "Sorted", .backend = "null", .quick = true};
  const auto verdict = [&](const std::string& code) {
    faults.code = code;
    const report::StabilityRecord r = runStability(job, context, nullptr);
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
  EXPECT_THROW(runStability(job, context, nullptr), rhi::Error);
  EXPECT_EQ(failedStability(job, "gone").verdict, Verdict::Fail);
}

/// The null backend's device, which says that it lacks a feature.
std::unique_ptr<rhi::Device> deviceWithout(rhi::Feature feature) {
  auto device = null_backend::makeBackend()->open({});
  const_cast<rhi::DeviceInfo&>(device->info()).features.erase(feature);
  return device;
}

TEST(StabilityFaults, WhatACasesSceneNeedsOfTheDeviceIsAskedFor) {
  rhi::ShaderLibrary shaders;
  shadowbench_shader_blob::addTo(shaders);
  const auto device = deviceWithout(rhi::Feature::DualSourceBlend);
  PipelineCache pipelines(*device);
  FrameQueries queries(*device);
  const DeviceContext context{*device, shaders, pipelines, queries};
  Scene glassy = floorScene();
  addHorizontal(glassy, add(glassy, glass(0.5f, {1, 0.5f, 0})), {0, 0.25f, 0}, 1, 1);
  glassy.materials.back().transmission = 1;
  Scene grey = glassy;
  grey.materials.back().transmission = 0;
  for (const TransparencyEntry* entry : transparencyTechniques()) {
    const std::string& name = entry->info.name;
    StabilityJob job{.caseId = "G8", .technique = "none", .transparency = name, .backend = "null", .quick = true};
    job.scene = "given";
    const auto asked = [&](const Scene& scene) {
      return runStability(job, context, nullptr, &scene);
    };
    const report::StabilityRecord lacking = asked(glassy);
    EXPECT_EQ(lacking.verdict, report::Verdict::Skipped) << name;
    EXPECT_EQ(lacking.why, "the device lacks " +
                               std::string(rhi::featureName(rhi::Feature::DualSourceBlend)) +
                               ", which " + name + " needs for coloured-transparency");
    EXPECT_EQ(asked(grey).verdict, report::Verdict::Pass) << name;
    // A case of its own scene, which has no glass, is asked as ever.
    EXPECT_EQ(runStability({.caseId = "G8", .technique = "none", .transparency = name, .backend = "null", .quick = true}, context, nullptr).verdict,
              report::Verdict::Pass)
        << name;
  }
}

}  // namespace
}  // namespace sb
