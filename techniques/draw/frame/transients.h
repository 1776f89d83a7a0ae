// Textures that hold something in one part of a frame alone. One of each part may be the same
// texture, where both have one description: so they take the memory of one.
#pragma once

#include <array>
#include <vector>

#include "backends/rhi/device.h"

namespace sb {

/// Parts of a frame, which follow one another for each layer of receivers.
enum class FramePart : uint8_t {
  Receivers,  ///< a shadow technique that answers by layers makes its answer (recordReceivers)
  Surfaces,   ///< the layer is drawn, and laid over what was drawn before; translucent surfaces of
              ///< techniques without layers are part of the opaque layer's
};

class Transients {
 public:
  explicit Transients(rhi::Device& device) : m_device(device) {}
  Transients(const Transients&) = delete;

  /// A texture that is the caller's in `part`. Whenever that begins, it holds nothing. Lives as
  /// long as this object. Memory counts once, under the label that came first. Outside frames.
  /// Throws rhi::Error when the device refuses.
  rhi::TextureId texture(const rhi::TextureDesc& desc, FramePart part);

  /// Between passes: the next part of the frame begins.
  void begin(rhi::CommandList& commands) const;

 private:
  struct Shared {
    rhi::Texture texture;
    std::array<bool, 2> taken{};  ///< by FramePart
  };
  rhi::Device& m_device;
  std::vector<Shared> m_textures;
};

}  // namespace sb
