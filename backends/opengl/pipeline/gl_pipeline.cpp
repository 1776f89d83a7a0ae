#include "backends/opengl/pipeline/gl_pipeline.h"

#include "backends/opengl/pipeline/gl_program.h"
#include "backends/opengl/resources/gl_formats.h"

namespace opengl {
namespace {

StencilOps stencilOps(const rhi::StencilFace& face) {
  return {stencilOp(face.fail), stencilOp(face.depthFail), stencilOp(face.pass)};
}

BlendTarget blendTarget(const rhi::BlendState& b) {
  return {b.enabled,          blendFactor(b.srcColor), blendFactor(b.dstColor),
          blendOp(b.colorOp), blendFactor(b.srcAlpha), blendFactor(b.dstAlpha),
          blendOp(b.alphaOp)};
}

FixedState fixedState(const rhi::GraphicsPipelineDesc& desc) {
  FixedState s;
  if (desc.raster.cull != rhi::CullMode::None)
    s.cullFace = desc.raster.cull == rhi::CullMode::Front ? GL_FRONT : GL_BACK;
  s.depthClamp = desc.raster.depthClamp;
  s.depthBias = {desc.raster.depthBiasSlope, desc.raster.depthBiasConstant};
  s.depthTest = desc.depth.test;
  s.depthWrite = desc.depth.write;
  s.depthCompare = compareOp(desc.depth.compare);
  s.stencilTest = desc.stencil.test;
  s.stencil = {stencilOps(desc.stencil.front), stencilOps(desc.stencil.back)};
  s.stencilCompare = {compareOp(desc.stencil.front.compare), compareOp(desc.stencil.back.compare)};
  s.stencilReadMask = desc.stencil.readMask;
  s.stencilWriteMask = desc.stencil.writeMask;
  s.colorMask.fill(0xF);
  for (size_t i = 0; i < desc.targets.size(); ++i) {
    s.blend[i] = blendTarget(desc.targets[i].blend);
    s.colorMask[i] = desc.targets[i].writeMask;
  }
  if (desc.logicOp) s.logicOp = logicOp(*desc.logicOp);
  s.sampleShading = desc.sampleShading;
  return s;
}

uint64_t usedSlots(std::span<const rhi::ShaderCode* const> stages) {
  uint64_t slots = 0;
  for (const rhi::ShaderCode* code : stages)
    for (const rhi::ShaderResource& resource : code->resources) slots |= 1ull << resource.slot;
  return slots;
}

}  // namespace

Pipeline::Pipeline(const Functions& gl, const rhi::GraphicsPipelineDesc& desc)
    : m_fixed(fixedState(desc)),
      m_vertexInput{desc.vertexBuffers, desc.attributes},
      m_topology(opengl::topology(desc.topology)) {
  std::vector<const rhi::ShaderCode*> stages = {desc.vertex};
  if (desc.geometry) stages.push_back(desc.geometry);
  if (desc.fragment) stages.push_back(desc.fragment);
  m_program = linkProgram(gl, desc.label, stages, desc.constants);
  m_slots = usedSlots(stages);
}

Pipeline::Pipeline(const Functions& gl, const rhi::ComputePipelineDesc& desc) {
  const rhi::ShaderCode* const stages[] = {desc.compute};
  m_program = linkProgram(gl, desc.label, stages, desc.constants);
  m_slots = usedSlots(stages);
}

}  // namespace opengl
