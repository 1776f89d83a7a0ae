// What everything that prepares passes for one cell shares.
#pragma once

#include "techniques/draw/frame/pipeline_cache.h"
#include "techniques/draw/frame/transients.h"
#include "techniques/draw/views/scene_view.h"
#include "techniques/plan/knobs.h"
#include "techniques/plan/plan.h"

namespace sb {

/// A device and the scene view, plan and knobs of a cell on it.
struct Context {
  rhi::Device& device;
  const rhi::ShaderLibrary& shaders;
  PipelineCache& pipelines;
  Transients& transients;
  SceneView& view;
  const Plan& plan;
  const Knobs& knobs;

  /// The pipeline of this description, specialized for the view's scene too.
  rhi::PipelineId pipeline(rhi::GraphicsPipelineDesc desc) const {
    const auto constants =
        declaredConstants({desc.vertex, desc.geometry, desc.fragment}, view.constants());
    desc.constants.insert(desc.constants.end(), constants.begin(), constants.end());
    return pipelines.get(desc);
  }
};

}  // namespace sb
