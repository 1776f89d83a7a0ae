#include "techniques/draw/frame/pipeline_cache.h"

#include <chrono>

namespace sb {
namespace {

/// Appends plain values as bytes.
struct Key {
  std::string bytes;
  template <class T>
  Key& operator<<(const T& value) {
    static_assert(std::is_trivially_copyable_v<T> && std::has_unique_object_representations_v<T>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  Key& operator<<(float value) { return *this << std::bit_cast<uint32_t>(value); }
  Key& operator<<(const rhi::ShaderCode* code) {
    bytes += code ? code->name : "-";
    bytes += '\0';
    return *this;
  }
  Key& operator<<(const std::vector<rhi::SpecConstant>& constants) {
    for (const auto& c : constants) *this << c.id << c.bits;
    return *this << uint8_t(0xFE);
  }
  Key& operator<<(const rhi::StencilFace& f) {
    return *this << f.compare << f.fail << f.depthFail << f.pass;
  }
};

}  // namespace

template <class Desc>
rhi::PipelineId PipelineCache::find(const std::string& key, const Desc& desc) {
  if (auto it = m_pipelines.find(key); it != m_pipelines.end()) return it->second;
  const auto start = std::chrono::steady_clock::now();
  rhi::Pipeline pipeline = m_device.createPipeline(desc);
  m_createMs += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                    .count();
  return m_pipelines.emplace(key, std::move(pipeline)).first->second;
}

rhi::PipelineId PipelineCache::get(const rhi::GraphicsPipelineDesc& d) {
  Key key;
  key << d.vertex << d.geometry << d.fragment << d.constants;
  for (const auto& b : d.vertexBuffers) key << b.stride << b.perInstance;
  key << uint8_t(0xFD);
  for (const auto& a : d.attributes) key << a.location << a.buffer << a.format << a.offset;
  key << uint8_t(0xFC) << d.topology << d.raster.cull << d.raster.depthClamp
      << d.raster.depthBiasConstant << d.raster.depthBiasSlope << d.depth.test << d.depth.write
      << d.depth.compare << d.stencil.test << d.stencil.front << d.stencil.back
      << d.stencil.readMask << d.stencil.writeMask;
  for (const auto& t : d.targets)
    key << t.format << t.blend.enabled << t.blend.srcColor << t.blend.dstColor << t.blend.colorOp
        << t.blend.srcAlpha << t.blend.dstAlpha << t.blend.alphaOp << t.writeMask;
  key << uint8_t(0xFB) << uint8_t(d.logicOp ? uint8_t(*d.logicOp) : 0xFF) << d.depthFormat
      << d.samples << d.sampleShading;
  return find(key.bytes, d);
}

rhi::PipelineId PipelineCache::get(const rhi::ComputePipelineDesc& desc) {
  Key key;
  key << desc.compute << desc.constants;
  return find("compute:" + key.bytes, desc);
}

std::vector<rhi::SpecConstant> declaredConstants(
    std::initializer_list<const rhi::ShaderCode*> stages,
    const std::vector<rhi::SpecConstant>& wanted) {
  std::vector<rhi::SpecConstant> declared;
  for (const rhi::SpecConstant& c : wanted)
    if (std::ranges::any_of(stages, [&](const rhi::ShaderCode* code) {
          return code && std::ranges::find(code->constants, c.id, &rhi::ShaderConstant::id) !=
                             code->constants.end();
        }))
      declared.push_back(c);
  return declared;
}

}  // namespace sb
