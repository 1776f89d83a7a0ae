#include "backends/rhi/ledger.h"

#include <algorithm>
#include <cassert>

namespace rhi {

void Ledger::add(Kind kind, uint32_t id, const std::string& label, uint64_t bytes) {
  m_entries[{kind, id}] = {label, bytes};
  m_total += bytes;
}

void Ledger::remove(Kind kind, uint32_t id) {
  auto it = m_entries.find({kind, id});
  assert(it != m_entries.end() && "destroyed twice");
  m_total -= it->second.bytes;
  m_entries.erase(it);
}

std::map<std::string, uint64_t> Ledger::bytesByLabel() const {
  std::map<std::string, uint64_t> sums;
  for (const auto& [key, entry] : m_entries)
    if (entry.bytes > 0) sums[entry.label] += entry.bytes;
  return sums;
}

std::string Ledger::describeAlive() const {
  static constexpr const char* kNames[] = {"buffer", "texture", "sampler", "pipeline",
                                           "query pool"};
  std::string text;
  for (const auto& [key, entry] : m_entries)
    text += (text.empty() ? "" : ", ") + std::string(kNames[size_t(key.first)]) + " '" +
            entry.label + "'";
  return text;
}

uint64_t textureBytes(const TextureDesc& desc) {
  uint64_t texels = 0;
  for (uint32_t mip = 0; mip < desc.mips; ++mip)
    texels += uint64_t(std::max(1u, desc.width >> mip)) * std::max(1u, desc.height >> mip) *
              std::max(1u, desc.depth >> mip);
  return texels * desc.layers * desc.samples * formatInfo(desc.format).texelBytes;
}

}  // namespace rhi
