// Book of what is alive on a device and what it takes: memory by label, and leaks at the end.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "backends/rhi/desc.h"

namespace rhi {

class Ledger {
 public:
  enum class Kind : uint8_t { Buffer, Texture, Sampler, Pipeline, QueryPool };

  void add(Kind kind, uint32_t id, const std::string& label, uint64_t bytes);
  void remove(Kind kind, uint32_t id);

  /// Bytes of all live buffers and textures: what was asked for, texel by texel, samples and mips
  /// included; the driver's padding is not in it.
  uint64_t totalBytes() const { return m_total; }
  /// Live bytes summed over objects of the same label.
  std::map<std::string, uint64_t> bytesByLabel() const;
  size_t alive() const { return m_entries.size(); }
  /// "texture 'shadow map', buffer 'nodes'"; empty when nothing is alive.
  std::string describeAlive() const;

 private:
  struct Entry {
    std::string label;
    uint64_t bytes = 0;
  };
  std::map<std::pair<Kind, uint32_t>, Entry> m_entries;
  uint64_t m_total = 0;
};

/// Bytes of a texture as the ledger counts it.
uint64_t textureBytes(const TextureDesc& desc);

}  // namespace rhi
