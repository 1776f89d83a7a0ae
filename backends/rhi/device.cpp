#include "backends/rhi/device.h"

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cstdio>
#include <cstdlib>

#include "backends/rhi/memory_limit.h"

namespace rhi {

Device::~Device() {
  // Too late for an exception: a leak is a programmer's error, and tests look at this line.
  if (m_ledger.alive() > 0) {
    std::fprintf(stderr, "rhi: leaked at destruction of device '%s': %s\n", m_info.name.c_str(),
                 m_ledger.describeAlive().c_str());
    assert(false && "objects outlive their device");
  }
}

Buffer Device::createBuffer(const BufferDesc& desc) {
  assert(!desc.label.empty() && desc.size > 0);
  requireFit(m_info, m_ledger.totalBytes(), desc);
  BufferId id = doCreate(desc);
  m_ledger.add(Ledger::Kind::Buffer, id.value, desc.label, desc.size);
  bookHostMemory(m_info, int64_t(desc.size));
  Buffer handle(this, id);  // first: an observer that throws leaves nothing behind
  if (m_observer) m_observer->created(id, desc);
  return handle;
}

Texture Device::createTexture(const TextureDesc& desc) {
  assert(!desc.label.empty() && desc.format != Format::Undefined);
  requireFit(m_info, m_ledger.totalBytes(), desc);
  TextureId id = doCreate(desc);
  m_ledger.add(Ledger::Kind::Texture, id.value, desc.label, textureBytes(desc));
  bookHostMemory(m_info, int64_t(textureBytes(desc)));
  Texture handle(this, id);  // first: an observer that throws leaves nothing behind
  if (m_observer) m_observer->created(id, desc);
  return handle;
}

Sampler Device::createSampler(const SamplerDesc& desc) {
  SamplerId id = doCreate(desc);
  m_ledger.add(Ledger::Kind::Sampler, id.value, desc.label, 0);
  Sampler handle(this, id);  // first: an observer that throws leaves nothing behind
  if (m_observer) m_observer->created(id, desc);
  return handle;
}

Pipeline Device::createPipeline(const GraphicsPipelineDesc& desc) {
  assert(!desc.label.empty() && desc.vertex);
  PipelineId id = doCreate(desc);
  m_ledger.add(Ledger::Kind::Pipeline, id.value, desc.label, 0);
  Pipeline handle(this, id);  // first: an observer that throws leaves nothing behind
  if (m_observer) m_observer->created(id, desc);
  return handle;
}

Pipeline Device::createPipeline(const ComputePipelineDesc& desc) {
  assert(!desc.label.empty() && desc.compute);
  PipelineId id = doCreate(desc);
  m_ledger.add(Ledger::Kind::Pipeline, id.value, desc.label, 0);
  Pipeline handle(this, id);  // first: an observer that throws leaves nothing behind
  if (m_observer) m_observer->created(id, desc);
  return handle;
}

QueryPool Device::createQueryPool(const QueryPoolDesc& desc) {
  assert(!desc.label.empty() && desc.count > 0);
  QueryPoolId id = doCreate(desc);
  m_ledger.add(Ledger::Kind::QueryPool, id.value, desc.label, 0);
  QueryPool handle(this, id);  // first: an observer that throws leaves nothing behind
  if (m_observer) m_observer->created(id, desc);
  return handle;
}

void Device::destroy(BufferId id) {
  if (m_observer) m_observer->destroyed(id);
  const uint64_t before = m_ledger.totalBytes();
  m_ledger.remove(Ledger::Kind::Buffer, id.value);
  bookHostMemory(m_info, -int64_t(before - m_ledger.totalBytes()));
  doDestroy(id);
}
void Device::destroy(TextureId id) {
  if (m_observer) m_observer->destroyed(id);
  const uint64_t before = m_ledger.totalBytes();
  m_ledger.remove(Ledger::Kind::Texture, id.value);
  bookHostMemory(m_info, -int64_t(before - m_ledger.totalBytes()));
  doDestroy(id);
}
void Device::destroy(SamplerId id) {
  if (m_observer) m_observer->destroyed(id);
  m_ledger.remove(Ledger::Kind::Sampler, id.value);
  doDestroy(id);
}
void Device::destroy(PipelineId id) {
  if (m_observer) m_observer->destroyed(id);
  m_ledger.remove(Ledger::Kind::Pipeline, id.value);
  doDestroy(id);
}
void Device::destroy(QueryPoolId id) {
  if (m_observer) m_observer->destroyed(id);
  m_ledger.remove(Ledger::Kind::QueryPool, id.value);
  doDestroy(id);
}

void Device::upload(BufferId buffer, uint64_t offset, std::span<const std::byte> bytes) {
  assert(!m_frame && "uploads happen between frames; inside one, CommandList::write");
  if (bytes.empty()) return;
  if (m_observer) m_observer->upload(buffer, offset, bytes.size());
  doUpload(buffer, offset, bytes);
}

void Device::upload(TextureId texture, const TextureRegion& region,
                    std::span<const std::byte> bytes) {
  assert(!m_frame && "uploads happen between frames");
  if (m_observer) m_observer->upload(texture, region, bytes.size());
  const TextureDesc& desc = textureDesc(texture);
  TextureRegion exact = region;
  if (exact.width == kAllRemaining) exact.width = std::max(1u, desc.width >> region.mip) - exact.x;
  if (exact.height == kAllRemaining)
    exact.height = std::max(1u, desc.height >> region.mip) - exact.y;
  assert(bytes.size() == size_t(exact.width) * exact.height *
                             hostTexelBytes(desc.format, Aspect::Color));
  doUpload(texture, exact, bytes);
}

std::vector<std::byte> Device::read(BufferId buffer, uint64_t offset, uint64_t size) {
  assert(!m_frame && "reads happen between frames");
  if (m_observer) m_observer->read(buffer, offset, size);
  std::vector<std::byte> bytes(size);
  doRead(buffer, offset, bytes);
  return bytes;
}

std::vector<std::byte> Device::read(TextureId texture, const TextureRegion& region,
                                    Aspect aspect) {
  assert(!m_frame && "reads happen between frames");
  if (m_observer) m_observer->read(texture, region);
  const TextureDesc& desc = textureDesc(texture);
  const uint32_t width = std::max(1u, desc.width >> region.mip);
  const uint32_t height = std::max(1u, desc.height >> region.mip);
  TextureRegion exact = region;
  if (exact.width == kAllRemaining) exact.width = width - exact.x;
  if (exact.height == kAllRemaining) exact.height = height - exact.y;
  if (aspect == Aspect::Color && formatInfo(desc.format).depth) aspect = Aspect::Depth;
  std::vector<std::byte> bytes(size_t(exact.width) * exact.height *
                               hostTexelBytes(desc.format, aspect));
  doRead(texture, exact, aspect, bytes);
  return bytes;
}

CommandList& Device::beginFrame() {
  assert(!m_frame && "frames do not nest");
  if (m_observer) m_observer->beginFrame();
  m_frame = &doBeginFrame();
  m_frame->m_counters = {};
  m_frame->m_observer = m_observer;
  return *m_frame;
}

Ticket Device::endFrame() {
  assert(m_frame && !m_frame->inPass());
  if (m_observer) m_observer->endFrame();
  const Ticket ticket = doEndFrame();  // may throw: then the frame is still there to be abandoned
  m_frame = nullptr;
  return ticket;
}

void Device::abandonFrame() noexcept {
  if (!m_frame) return;
  m_frame->m_inPass = false;
  m_frame = nullptr;
  try {
    doAbandonFrame();
    if (m_observer) m_observer->abandonFrame();
  } catch (const std::exception& e) {
    report({.source = "rhi", .rule = "abandonFrame", .text = e.what()});
  }
}

void Device::wait(Ticket ticket) { doWait(ticket); }

void Device::waitIdle() { doWaitIdle(); }

std::vector<uint64_t> Device::readQueries(QueryPoolId pool, uint32_t first, uint32_t count) {
  const bool statistics = queryPoolDesc(pool).kind == QueryKind::PipelineStatistics;
  std::vector<uint64_t> values(size_t(count) * (statistics ? kStatisticsValues : 1));
  doReadQueries(pool, first, count, values);
  return values;
}

std::unique_ptr<Surface> Device::createSurface(const SurfaceDesc& desc) {
  throw Error("createSurface", "", "presentation to a window ('" + desc.label +
                                       "') is not available on backend " + m_info.backend);
}

std::vector<Message> Device::takeMessages() { return std::exchange(m_messages, {}); }

void Device::report(Message message) { m_messages.push_back(std::move(message)); }

void Device::setObserver(Observer* observer) {
  assert(!m_frame);
  m_observer = observer;
}

size_t chooseDevice(const std::vector<DeviceInfo>& devices, std::string_view selector) {
  auto lower = [](std::string_view text) {
    std::string out(text);
    std::ranges::transform(out, out.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return out;
  };
  std::string list;
  for (const DeviceInfo& d : devices)
    list += (list.empty() ? "" : "; ") + std::to_string(d.index) + " = " + d.name +
            (d.unusable.empty() ? "" : " (unusable: " + d.unusable + ")");
  const bool byIndex = !selector.empty() && std::ranges::all_of(selector, [](unsigned char c) {
    return std::isdigit(c) != 0;
  });
  size_t best = devices.size();
  for (size_t i = 0; i < devices.size(); ++i) {
    const DeviceInfo& d = devices[i];
    const bool matches = selector.empty() ? true
                         : byIndex        ? std::to_string(d.index) == selector
                                          : lower(d.name).find(lower(selector)) != std::string::npos;
    if (!matches || (selector.empty() && !d.unusable.empty())) continue;
    if (best == devices.size() || d.type < devices[best].type) best = i;
  }
  if (best == devices.size())
    throw Error("device selection", "",
                selector.empty() ? "no usable device; found: " + (list.empty() ? "nothing" : list)
                                 : "no device matches '" + std::string(selector) +
                                       "'; there are: " + (list.empty() ? "nothing" : list));
  if (!devices[best].unusable.empty())
    throw Error("device selection", "",
                devices[best].name + " cannot be used: " + devices[best].unusable);
  return best;
}

}  // namespace rhi
