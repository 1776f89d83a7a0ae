// Textures: an image, its views by sub-range, and the layout and synchronization state of every mip
// and layer. Between passes an image rests in the one layout that all shader accesses use, so that
// descriptors do not depend on what a frame did before.
#pragma once

#include <vector>

#include "backends/vulkan/resources/vk_buffer.h"

namespace vulkan {

struct SubresourceState : AccessState {
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

/// A TextureView with its counts resolved.
struct ViewRange {
  uint32_t baseMip = 0;
  uint32_t mipCount = 1;
  uint32_t baseLayer = 0;
  uint32_t layerCount = 1;
  bool operator==(const ViewRange&) const = default;
};

struct Texture {
  rhi::TextureDesc desc;
  VkImage image = VK_NULL_HANDLE;
  Allocation allocation;
  VkImageAspectFlags aspects = 0;
  VkImageLayout restLayout = VK_IMAGE_LAYOUT_GENERAL;
  std::vector<SubresourceState> states;  ///< layer-major: layer * mips + mip

  SubresourceState& state(uint32_t mip, uint32_t layer) { return states[layer * desc.mips + mip]; }
  ViewRange resolve(const rhi::TextureView& view) const;

  struct CachedView {
    ViewRange range;
    VkImageAspectFlags aspects = 0;
    VkImageView view = VK_NULL_HANDLE;
  };
  std::vector<CachedView> views;
};

Texture createTexture(const Context& context, Memory& memory, const rhi::TextureDesc& desc);
void destroyTexture(const Context& context, Memory& memory, const Texture& texture);

/// Created on first use, destroyed with the texture.
VkImageView viewOf(const Context& context, Texture& texture, const ViewRange& range,
                   VkImageAspectFlags aspects);

}  // namespace vulkan
