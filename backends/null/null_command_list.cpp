#include "backends/null/null_command_list.h"

#include <cassert>
#include <cstring>

#include "backends/null/null_device.h"

namespace null_backend {

void CommandList::record(CallKind kind, const std::string& pipeline, const std::string& resource,
                         std::vector<uint64_t> args) {
  m_device.record({kind, m_pass, pipeline, resource, std::move(args)});
}

void CommandList::doBeginPass(const rhi::PassDesc& desc) {
  m_pass = desc.label;
  record(CallKind::BeginPass, "", "", {});
}

void CommandList::doEndPass() {
  record(CallKind::EndPass, "", "", {});
  m_pass.clear();
}

void CommandList::doDraw(const rhi::DrawState& state, const rhi::DrawArgs& args) {
  record(CallKind::Draw, m_device.label(state.pipeline), "",
         {args.vertexCount, args.instanceCount, args.firstVertex});
}

void CommandList::doDrawIndexed(const rhi::DrawState& state,
                                std::span<const rhi::DrawIndexedArgs> draws) {
  for (const rhi::DrawIndexedArgs& args : draws)
    record(CallKind::DrawIndexed, m_device.label(state.pipeline), "",
           {args.indexCount, args.instanceCount, args.firstIndex, uint64_t(args.vertexOffset),
            args.firstInstance});
}

void CommandList::doDrawIndirect(const rhi::DrawState& state, const rhi::IndirectArgs& args,
                                 bool indexed) {
  record(indexed ? CallKind::DrawIndexedIndirect : CallKind::DrawIndirect,
         m_device.label(state.pipeline), m_device.bufferDesc(args.buffer).label,
         {args.offset, args.drawCount, args.stride});
}

void CommandList::doDispatch(const rhi::DispatchState& state, uint32_t x, uint32_t y, uint32_t z) {
  record(CallKind::Dispatch, m_device.label(state.pipeline), "", {x, y, z});
}

void CommandList::doDispatchIndirect(const rhi::DispatchState& state, rhi::BufferId args,
                                     uint64_t offset) {
  record(CallKind::DispatchIndirect, m_device.label(state.pipeline),
         m_device.bufferDesc(args).label, {offset});
}

void CommandList::doWrite(rhi::BufferId id, uint64_t offset, std::span<const std::byte> bytes) {
  Buffer& buffer = m_device.buffer(id);
  assert(offset + bytes.size() <= buffer.bytes.size());
  std::memcpy(&buffer.bytes[offset], bytes.data(), bytes.size());
  record(CallKind::Write, "", buffer.desc.label, {offset, bytes.size()});
}

void CommandList::doFill(rhi::BufferId id, uint64_t offset, uint64_t size, uint32_t word) {
  Buffer& buffer = m_device.buffer(id);
  assert(offset + size <= buffer.bytes.size());
  for (uint64_t at = offset; at < offset + size; at += 4) std::memcpy(&buffer.bytes[at], &word, 4);
  record(CallKind::Fill, "", buffer.desc.label, {offset, size});
}

void CommandList::doCopy(rhi::BufferId source, uint64_t sourceOffset, rhi::BufferId target,
                         uint64_t targetOffset, uint64_t size) {
  const Buffer& from = m_device.buffer(source);
  Buffer& to = m_device.buffer(target);
  assert(sourceOffset + size <= from.bytes.size() && targetOffset + size <= to.bytes.size());
  std::memmove(to.bytes.data() + targetOffset, from.bytes.data() + sourceOffset, size);
  record(CallKind::Copy, "", to.desc.label, {targetOffset, size});
}

void CommandList::doCopy(const rhi::TextureView& source, const rhi::TextureView& target) {
  const Texture& from = m_device.texture(source.texture);
  Texture& to = m_device.texture(target.texture);
  const uint32_t mips =
      source.mipCount == rhi::kAllRemaining ? from.desc().mips - source.baseMip : source.mipCount;
  for (uint32_t i = 0; i < mips; ++i) {
    const uint32_t all = from.slices(source.baseMip + i) - source.baseLayer;
    const uint32_t layers = source.layerCount == rhi::kAllRemaining ? all : source.layerCount;
    for (uint32_t layer = 0; layer < layers; ++layer)
      to.copyFrom(from, source.baseMip + i, source.baseLayer + layer, target.baseMip + i,
                  target.baseLayer + layer);
  }
  record(CallKind::Copy, "", to.desc().label, {});
}

void CommandList::doTimestamp(rhi::QueryPoolId pool, uint32_t index) {
  m_device.stamp(pool, index);
  record(CallKind::Timestamp, "", m_device.queryPoolDesc(pool).label, {index});
}

void CommandList::doBeginQuery(rhi::QueryPoolId pool, uint32_t index) {
  record(CallKind::BeginQuery, "", m_device.queryPoolDesc(pool).label, {index});
}

void CommandList::doEndQuery(rhi::QueryPoolId pool, uint32_t index) {
  record(CallKind::EndQuery, "", m_device.queryPoolDesc(pool).label, {index});
}

}  // namespace null_backend
