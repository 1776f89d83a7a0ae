// What a frame changes is undone when the frame is abandoned; what is destroyed is forgotten.
#include "backends/vulkan/commands/vk_barriers.h"

namespace vulkan {

void Barriers::remember(Buffer& buffer) {
  if (!m_inFrame) return;
  m_changes.push_back({.buffer = &buffer});
  static_cast<AccessState&>(m_changes.back().before) = buffer.state;
}

void Barriers::remember(Texture& texture, SubresourceState& part) {
  if (m_inFrame) m_changes.push_back({.texture = &texture, .part = &part, .before = part});
}

void Barriers::forget(const Texture& texture) {
  std::erase(m_new, &texture);
  std::erase(m_initialised, &texture);
  std::erase_if(m_changes, [&](const Change& c) { return c.texture == &texture; });
}

void Barriers::forget(const Buffer& buffer) {
  std::erase(m_touched, &buffer);
  std::erase_if(m_changes, [&](const Change& c) { return c.buffer == &buffer; });
}

void Barriers::beginFrame() {
  m_inFrame = true;
  m_changes.clear();
  m_initialised.clear();
}

void Barriers::endFrame() { m_inFrame = false; }

void Barriers::abandonFrame() {
  m_inFrame = false;
  for (auto change = m_changes.rbegin(); change != m_changes.rend(); ++change) {
    if (change->buffer)
      change->buffer->state = change->before;
    else
      *change->part = change->before;
  }
  // Their layouts were set after they were made in this frame: they are as new as before.
  for (Texture* texture : m_initialised) {
    for (SubresourceState& state : texture->states) state = {};
    m_new.push_back(texture);
  }
  m_changes.clear();
  m_initialised.clear();
  m_wants.clear();
  m_buffers.clear();
  m_images.clear();
  m_touched.clear();
  m_transferring = false;
  ++m_batch;
}

}  // namespace vulkan
