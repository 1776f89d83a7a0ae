// Slot map of a backend's objects by id. A stale id (used after destruction) is caught.
#pragma once

#include <cassert>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "backends/rhi/handles.h"

namespace rhi {

template <class Tag, class T>
class Pool {
 public:
  Id<Tag> add(T object) {
    uint32_t slot;
    if (m_free.empty()) {
      slot = uint32_t(m_slots.size());
      m_slots.emplace_back();
    } else {
      slot = m_free.back();
      m_free.pop_back();
    }
    m_slots[slot].object.emplace(std::move(object));
    return {make(slot)};
  }
  bool contains(Id<Tag> id) const {
    uint32_t slot = (id.value & kSlotMask) - 1;
    return id && slot < m_slots.size() && m_slots[slot].object && make(slot) == id.value;
  }
  T& get(Id<Tag> id) {
    assert(contains(id) && "use of a destroyed or foreign object");
    return *m_slots[(id.value & kSlotMask) - 1].object;
  }
  const T& get(Id<Tag> id) const { return const_cast<Pool*>(this)->get(id); }
  /// Takes the object out; its id is invalid from here on.
  T remove(Id<Tag> id) {
    assert(contains(id) && "destroyed twice");
    uint32_t slot = (id.value & kSlotMask) - 1;
    T object = std::move(*m_slots[slot].object);
    m_slots[slot].object.reset();
    m_slots[slot].generation = (m_slots[slot].generation + 1) & 0xFFF;
    m_free.push_back(slot);
    return object;
  }

 private:
  static constexpr uint32_t kSlotMask = (1u << 20) - 1;
  struct Slot {
    std::optional<T> object;
    uint32_t generation = 0;
  };
  uint32_t make(uint32_t slot) const { return (m_slots[slot].generation << 20) | (slot + 1); }

  std::deque<Slot> m_slots;  // a deque: references stay valid while others are added
  std::vector<uint32_t> m_free;
};

}  // namespace rhi
