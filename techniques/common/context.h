// What everything that prepares passes for one cell shares.
#pragma once

#include "techniques/common/knobs.h"
#include "techniques/common/pipeline_cache.h"
#include "techniques/common/plan.h"
#include "techniques/common/scene_view.h"

namespace sb {

/// A device and the scene view, plan and knobs of a cell on it.
struct Context {
  rhi::Device& device;
  const rhi::ShaderLibrary& shaders;
  PipelineCache& pipelines;
  SceneView& view;
  const Plan& plan;
  const Knobs& knobs;
};

}  // namespace sb
