// Pipelines of one device by content. Cells that need the same pipeline share it, so that the driver
// compiles it once in a process (0.4 s each on software drivers, facts.md).
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "backends/rhi/device.h"

namespace sb {

class PipelineCache {
 public:
  explicit PipelineCache(rhi::Device& device) : m_device(device) {}

  /// The pipeline of this description; made at first use. `label` is not part of the content.
  rhi::PipelineId get(const rhi::GraphicsPipelineDesc& desc);
  rhi::PipelineId get(const rhi::ComputePipelineDesc& desc);
  /// Time spent creating pipelines so far, milliseconds (drivers may defer work to the first draw).
  double createMs() const { return m_createMs; }
  size_t size() const { return m_pipelines.size(); }

 private:
  template <class Desc>
  rhi::PipelineId find(const std::string& key, const Desc& desc);

  rhi::Device& m_device;
  std::unordered_map<std::string, rhi::Pipeline> m_pipelines;
  double m_createMs = 0;
};

/// The values of `wanted` that one of the stages declares: a branch that a shader does not have
/// needs no constant.
std::vector<rhi::SpecConstant> declaredConstants(
    std::initializer_list<const rhi::ShaderCode*> stages,
    const std::vector<rhi::SpecConstant>& wanted);

}  // namespace sb
