// A pool of nodes that shaders link into lists (Yang, Hensley, Gruen, Thibieroz 2010): a word a list
// that names its first node, the nodes, and a counter of those that were claimed. What finds no place
// is dropped and counted: nothing is written beyond the pool. Shaders: common/list_pool.glsl.
#pragma once

#include <array>
#include <optional>

#include "backends/rhi/device.h"

namespace sb {

class ListPool {
 public:
  ListPool() = default;
  /// `lists`: how many. `nodeWords`: 32-bit words of a node. `wanted`: nodes; the pool has fewer
  /// where the device cannot bind as many (Limits::maxStorageRange). Throws rhi::Error when the
  /// device refuses.
  ListPool(rhi::Device& device, uint64_t lists, uint32_t nodeWords, uint64_t wanted);

  /// Empties all lists. Before the pass that fills them.
  void clear(rhi::CommandList& commands);
  /// Of the pass that fills the lists, and of those that walk them.
  std::array<rhi::ResourceUse, 3> writes() const;
  std::array<rhi::ResourceUse, 2> reads() const;
  /// Heads, nodes, counter: three storage slots from `slot` on.
  std::array<rhi::Binding, 3> bindings(uint32_t slot) const;

  uint64_t capacity() const { return m_capacity; }  ///< nodes
  struct Overflow {
    uint32_t asked = 0;    ///< nodes that were asked for
    uint32_t dropped = 0;  ///< of them found no place
  };
  /// Of the last frame that filled the lists; nothing if all found a place. Reads back: call between
  /// frames.
  std::optional<Overflow> overflow();

 private:
  rhi::Device* m_device = nullptr;
  uint64_t m_capacity = 0;
  uint64_t m_headBytes = 0;
  bool m_filled = false;
  rhi::Buffer m_heads, m_nodes, m_asked;
};

}  // namespace sb
