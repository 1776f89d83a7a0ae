#include "backends/rhi/command_list.h"

#include <cassert>

#include "backends/rhi/observer.h"

namespace rhi {

Counters operator-(const Counters& a, const Counters& b) {
  return {a.passes - b.passes, a.draws - b.draws, a.dispatches - b.dispatches,
          a.triangles - b.triangles};
}

namespace {

/// The same indices for the next instances.
bool follows(const DrawIndexedArgs& args, const DrawIndexedArgs& before) {
  return args.indexCount == before.indexCount && args.firstIndex == before.firstIndex &&
         args.vertexOffset == before.vertexOffset &&
         args.firstInstance == before.firstInstance + before.instanceCount;
}

}  // namespace

PassScope::~PassScope() noexcept(false) {
  if (std::uncaught_exceptions() == m_exceptions) end();
}

void PassScope::end() {
  if (auto* list = std::exchange(m_list, nullptr)) list->endPass();
}

PassScope CommandList::beginPass(const PassDesc& desc) {
  assert(!m_inPass && "passes do not nest");
  if (m_observer) m_observer->beginPass(desc);
  doBeginPass(desc);
  m_inPass = true;
  ++m_counters.passes;
  return PassScope(this);
}

void CommandList::endPass() {
  assert(m_inPass);
  if (m_observer) m_observer->endPass();
  doEndPass();
  m_inPass = false;
}

void CommandList::draw(const DrawState& state, const DrawArgs& args) {
  assert(m_inPass);
  if (m_observer) m_observer->draw(state, args);
  ++m_counters.draws;
  m_counters.triangles += uint64_t(args.vertexCount / 3) * args.instanceCount;
  doDraw(state, args);
}

void CommandList::drawIndexed(const DrawState& state, std::span<const DrawIndexedArgs> draws) {
  assert(m_inPass);
  m_joined.clear();
  for (const DrawIndexedArgs& args : draws) {
    if (m_observer) m_observer->drawIndexed(state, args);
    m_counters.triangles += uint64_t(args.indexCount / 3) * args.instanceCount;
    if (!m_joined.empty() && follows(args, m_joined.back()))
      m_joined.back().instanceCount += args.instanceCount;
    else
      m_joined.push_back(args);
  }
  m_counters.draws += draws.size();
  if (!m_joined.empty()) doDrawIndexed(state, m_joined);
}

void CommandList::drawIndirect(const DrawState& state, const IndirectArgs& args) {
  assert(m_inPass);
  if (m_observer) m_observer->drawIndirect(state, args, false);
  m_counters.draws += args.drawCount;
  doDrawIndirect(state, args, false);
}

void CommandList::drawIndexedIndirect(const DrawState& state, const IndirectArgs& args) {
  assert(m_inPass);
  if (m_observer) m_observer->drawIndirect(state, args, true);
  m_counters.draws += args.drawCount;
  doDrawIndirect(state, args, true);
}

void CommandList::dispatch(const DispatchState& state, uint32_t x, uint32_t y, uint32_t z) {
  assert(m_inPass);
  if (m_observer) m_observer->dispatch(state, x, y, z);
  ++m_counters.dispatches;
  doDispatch(state, x, y, z);
}

void CommandList::dispatchIndirect(const DispatchState& state, BufferId args, uint64_t offset) {
  assert(m_inPass);
  if (m_observer) m_observer->dispatchIndirect(state, args, offset);
  ++m_counters.dispatches;
  doDispatchIndirect(state, args, offset);
}

void CommandList::write(BufferId buffer, uint64_t offset, std::span<const std::byte> bytes) {
  assert(!m_inPass && "writes happen between passes");
  if (bytes.empty()) return;
  if (m_observer) m_observer->write(buffer, offset, bytes.size());
  doWrite(buffer, offset, bytes);
}

void CommandList::fill(BufferId buffer, uint64_t offset, uint64_t size, uint32_t word) {
  assert(!m_inPass && offset % 4 == 0 && size % 4 == 0);
  if (m_observer) m_observer->fill(buffer, offset, size);
  doFill(buffer, offset, size, word);
}

void CommandList::copy(BufferId source, uint64_t sourceOffset, BufferId target,
                       uint64_t targetOffset, uint64_t size) {
  assert(!m_inPass);
  if (m_observer) m_observer->copy(source, sourceOffset, target, targetOffset, size);
  doCopy(source, sourceOffset, target, targetOffset, size);
}

void CommandList::copy(const TextureView& source, const TextureView& target) {
  assert(!m_inPass);
  if (m_observer) m_observer->copy(source, target);
  doCopy(source, target);
}

void CommandList::discard(TextureId texture) {
  assert(!m_inPass && "what a pass uses is discarded between passes");
  if (m_observer) m_observer->discard(texture);
}

void CommandList::timestamp(QueryPoolId pool, uint32_t index) {
  assert(!m_inPass && "stamps stand between passes");
  if (m_observer) m_observer->timestamp(pool, index);
  doTimestamp(pool, index);
}

void CommandList::beginQuery(QueryPoolId pool, uint32_t index) {
  assert(m_inPass);
  if (m_observer) m_observer->beginQuery(pool, index);
  doBeginQuery(pool, index);
}

void CommandList::endQuery(QueryPoolId pool, uint32_t index) {
  assert(m_inPass);
  if (m_observer) m_observer->endQuery(pool, index);
  doEndQuery(pool, index);
}

}  // namespace rhi
