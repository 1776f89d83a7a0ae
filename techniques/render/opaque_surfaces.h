// The opaque and perforated surfaces that a camera sees, by the pipelines that draw them.
#pragma once

#include <map>

#include "techniques/draw/draw_list.h"
#include "techniques/render/technique.h"

namespace sb {

class CameraPass;

class OpaqueSurfaces {
 public:
  OpaqueSurfaces() = default;
  /// Where the shadow technique answers by layers, their depth is drawn before they are shaded.
  OpaqueSurfaces(const Context& context, const CameraPass& camera);

  /// What the camera shows has changed.
  void refill(const CameraPass& camera);
  /// Depth alone.
  void drawDepth(rhi::CommandList& commands, DrawList& draws) const;
  /// Shaded through the technique's visibility; where depth was drawn before, only what it shows.
  void drawShaded(rhi::CommandList& commands, DrawList& draws) const;
  /// By pipelines that are not their own.
  void drawWith(rhi::CommandList& commands, DrawList& draws, rhi::PipelineId singleSided,
                rhi::PipelineId doubleSided) const;

 private:
  struct Pipelines {
    rhi::PipelineId depth, shaded;
  };
  /// Instances that share a pipeline. Single-sided materials show no back faces (glTF); to light
  /// they are two-sided all the same.
  struct Bucket {
    bool masked = false;
    bool doubleSided = false;
    Pipelines pipelines;
    std::vector<uint32_t> instances;
  };
  Pipelines makePipelines(const Context& context, const CameraPass& camera,
                          const Bucket& bucket) const;

  std::vector<Bucket> m_buckets;
  std::map<std::pair<bool, bool>, Pipelines> m_pipelines;  ///< by masked and double-sided
};

}  // namespace sb
