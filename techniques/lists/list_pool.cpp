#include "techniques/lists/list_pool.h"

#include <algorithm>
#include <cstring>

#include "shaders/common/shared_lists.h"

namespace sb {

ListPool::ListPool(rhi::Device& device, uint64_t lists, uint32_t nodeWords, uint64_t wanted)
    : m_device(&device), m_headBytes(lists * 4) {
  const uint64_t nodeBytes = uint64_t(nodeWords) * 4;
  m_capacity =
      std::min(std::max<uint64_t>(1, wanted), device.info().limits.maxStorageRange / nodeBytes);
  auto buffer = [&](const char* label, uint64_t size) {
    return device.createBuffer(
        {.label = label,
         .size = size,
         .use = rhi::BufferUse::Storage | rhi::BufferUse::CopyTarget | rhi::BufferUse::CopySource});
  };
  m_heads = buffer("list heads", m_headBytes);
  m_nodes = buffer("list nodes", m_capacity * nodeBytes);
  m_asked = buffer("list counter", 16);
}

void ListPool::clear(rhi::CommandList& commands) {
  commands.fill(m_heads, 0, m_headBytes, END_OF_LIST);
  commands.fill(m_asked, 0, 4, 0);
  m_filled = true;
}

std::array<rhi::ResourceUse, 3> ListPool::writes() const {
  return {rhi::use(m_heads.id(), rhi::Access::StorageWrite),
          rhi::use(m_nodes.id(), rhi::Access::StorageWrite),
          rhi::use(m_asked.id(), rhi::Access::StorageWrite)};
}

std::array<rhi::ResourceUse, 2> ListPool::reads() const {
  return {rhi::use(m_heads.id(), rhi::Access::StorageRead),
          rhi::use(m_nodes.id(), rhi::Access::StorageRead)};
}

std::array<rhi::Binding, 3> ListPool::bindings(uint32_t slot) const {
  return {rhi::storageAt(slot, m_heads), rhi::storageAt(slot + 1, m_nodes),
          rhi::storageAt(slot + 2, m_asked)};
}

std::optional<ListPool::Overflow> ListPool::overflow() {
  if (!m_filled) return {};
  uint32_t asked = 0;
  std::memcpy(&asked, m_device->read(m_asked, 0, 4).data(), 4);
  if (asked <= m_capacity) return {};
  return Overflow{asked, asked - uint32_t(m_capacity)};
}

}  // namespace sb
