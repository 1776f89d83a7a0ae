#include "backends/null/null_device.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace null_backend {
namespace {

constexpr uint64_t kTickNs = 1000;

/// The one rule about constants that every backend enforces.
void checkConstants(const std::string& label, const std::vector<rhi::SpecConstant>& constants,
                    std::initializer_list<const rhi::ShaderCode*> stages) {
  for (const rhi::SpecConstant& constant : constants) {
    const bool declared = std::ranges::any_of(stages, [&](const rhi::ShaderCode* stage) {
      return stage && std::ranges::any_of(stage->constants,
                                          [&](const auto& c) { return c.id == constant.id; });
    });
    if (!declared)
      throw rhi::Error("createPipeline", "",
                       "'" + label + "': no stage declares specialization constant " +
                           std::to_string(constant.id));
  }
}

}  // namespace

Device::Device(rhi::DeviceInfo info) { m_info = std::move(info); }

rhi::FormatCaps Device::formatCaps(rhi::Format format) const {
  if (format == rhi::Format::Undefined) return {};
  const rhi::FormatInfo& info = rhi::formatInfo(format);
  const bool integer = info.kind == rhi::FormatKind::Uint || info.kind == rhi::FormatKind::Sint;
  return {.sampled = true,
          .linearFilter = !integer,
          .colorTarget = !info.depth,
          .blend = !info.depth && !integer,
          .depthTarget = info.depth,
          .storage = !info.depth && format != rhi::Format::RGBA8Srgb,
          .storageAtomic = format == rhi::Format::R32Uint || format == rhi::Format::R32Sint,
          .sampleCounts = m_info.limits.sampleCounts};
}

const rhi::BufferDesc& Device::bufferDesc(rhi::BufferId id) const { return m_buffers.get(id).desc; }
const rhi::TextureDesc& Device::textureDesc(rhi::TextureId id) const {
  return m_textures.get(id).desc();
}
const rhi::QueryPoolDesc& Device::queryPoolDesc(rhi::QueryPoolId id) const {
  return m_queryPools.get(id).desc;
}

rhi::BufferId Device::doCreate(const rhi::BufferDesc& desc) {
  return m_buffers.add({desc, std::vector<std::byte>(desc.size)});
}
rhi::TextureId Device::doCreate(const rhi::TextureDesc& desc) {
  return m_textures.add(Texture(desc));
}
rhi::SamplerId Device::doCreate(const rhi::SamplerDesc& desc) { return m_samplers.add(desc.label); }
rhi::PipelineId Device::doCreate(const rhi::GraphicsPipelineDesc& desc) {
  checkConstants(desc.label, desc.constants, {desc.vertex, desc.geometry, desc.fragment});
  return m_pipelines.add(desc.label);
}
rhi::PipelineId Device::doCreate(const rhi::ComputePipelineDesc& desc) {
  checkConstants(desc.label, desc.constants, {desc.compute});
  return m_pipelines.add(desc.label);
}
rhi::QueryPoolId Device::doCreate(const rhi::QueryPoolDesc& desc) {
  const bool statistics = desc.kind == rhi::QueryKind::PipelineStatistics;
  return m_queryPools.add(
      {desc, std::vector<uint64_t>(size_t(desc.count) * (statistics ? kStatisticsValues : 1))});
}

void Device::doDestroy(rhi::BufferId id) { m_buffers.remove(id); }
void Device::doDestroy(rhi::TextureId id) { m_textures.remove(id); }
void Device::doDestroy(rhi::SamplerId id) { m_samplers.remove(id); }
void Device::doDestroy(rhi::PipelineId id) { m_pipelines.remove(id); }
void Device::doDestroy(rhi::QueryPoolId id) { m_queryPools.remove(id); }

void Device::doUpload(rhi::BufferId id, uint64_t offset, std::span<const std::byte> bytes) {
  std::vector<std::byte>& target = m_buffers.get(id).bytes;
  assert(offset + bytes.size() <= target.size());
  std::memcpy(target.data() + offset, bytes.data(), bytes.size());
}

void Device::doUpload(rhi::TextureId id, const rhi::TextureRegion& region,
                      std::span<const std::byte> bytes) {
  m_textures.get(id).store(region, bytes);
}

void Device::doRead(rhi::BufferId id, uint64_t offset, std::span<std::byte> out) {
  const std::vector<std::byte>& source = m_buffers.get(id).bytes;
  assert(offset + out.size() <= source.size());
  if (!out.empty()) std::memcpy(out.data(), source.data() + offset, out.size());
}

void Device::doRead(rhi::TextureId id, const rhi::TextureRegion& region, rhi::Aspect aspect,
                    std::span<std::byte> out) {
  m_textures.get(id).load(region, aspect, out);
}

void Device::stamp(rhi::QueryPoolId pool, uint32_t index) {
  m_queryPools.get(pool).values.at(index) = m_clock += kTickNs;
}

void Device::doReadQueries(rhi::QueryPoolId id, uint32_t first, uint32_t count,
                           std::span<uint64_t> out) {
  const std::vector<uint64_t>& values = m_queryPools.get(id).values;
  const size_t width = out.size() / count;
  assert((first + count) * width <= values.size());
  std::copy_n(values.begin() + ptrdiff_t(first * width), out.size(), out.begin());
}

}  // namespace null_backend
