// Typed ids and move-only owning handles of device objects.
#pragma once

#include <cstdint>
#include <utility>

namespace rhi {

class Device;

/// Names an object of a device; 0 is no object. The low 20 bits are a slot, the rest a generation,
/// so that use after destruction is detected. Copyable: it owns nothing.
template <class Tag>
struct Id {
  uint32_t value = 0;
  explicit operator bool() const { return value != 0; }
  bool operator==(const Id&) const = default;
};

using BufferId = Id<struct BufferTag>;
using TextureId = Id<struct TextureTag>;
using SamplerId = Id<struct SamplerTag>;
using PipelineId = Id<struct PipelineTag>;
using QueryPoolId = Id<struct QueryPoolTag>;

/// Owns one object; destroys it (once the GPU no longer uses it) when it goes out of scope.
/// Converts to its id, which is what every other call takes. Must not outlive its device.
template <class Tag>
class Handle {
 public:
  Handle() = default;
  Handle(Device* device, Id<Tag> id) : m_device(device), m_id(id) {}
  Handle(Handle&& other) noexcept
      : m_device(std::exchange(other.m_device, nullptr)), m_id(std::exchange(other.m_id, {})) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      reset();
      m_device = std::exchange(other.m_device, nullptr);
      m_id = std::exchange(other.m_id, {});
    }
    return *this;
  }
  ~Handle() { reset(); }

  void reset();  // defined in device.h
  Id<Tag> id() const { return m_id; }
  operator Id<Tag>() const { return m_id; }
  explicit operator bool() const { return bool(m_id); }

 private:
  Device* m_device = nullptr;
  Id<Tag> m_id;
};

using Buffer = Handle<BufferTag>;
using Texture = Handle<TextureTag>;
using Sampler = Handle<SamplerTag>;
using Pipeline = Handle<PipelineTag>;
using QueryPool = Handle<QueryPoolTag>;

}  // namespace rhi
