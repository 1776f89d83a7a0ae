#include "backends/vulkan/resources/vk_texture.h"

#include <algorithm>
#include <cassert>

#include "backends/rhi/ledger.h"
#include "backends/rhi/memory_limit.h"
#include "backends/vulkan/device/vk_formats.h"

namespace vulkan {
namespace {

using rhi::TextureUse;

VkImageUsageFlags usageOf(const rhi::TextureDesc& desc) {
  VkImageUsageFlags usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  if (has(desc.use, TextureUse::Sampled)) usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
  if (has(desc.use, TextureUse::ColorTarget)) usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  if (has(desc.use, TextureUse::DepthTarget)) usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  if (has(desc.use, TextureUse::Storage)) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
  return usage;
}

// Storage images stay in GENERAL even while sampled: one image may be both in one pass.
VkImageLayout restLayoutOf(const rhi::TextureDesc& desc) {
  if (has(desc.use, TextureUse::Storage)) return VK_IMAGE_LAYOUT_GENERAL;
  // Depth is read while stencil is written.
  if (rhi::formatInfo(desc.format).stencil && has(desc.use, TextureUse::DepthTarget))
    return VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_STENCIL_ATTACHMENT_OPTIMAL;
  if (rhi::formatInfo(desc.format).depth) return VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL;
  if (has(desc.use, TextureUse::Sampled)) return VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  if (has(desc.use, TextureUse::ColorTarget)) return VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  return VK_IMAGE_LAYOUT_GENERAL;
}

void requireSupport(const Context& context, const rhi::TextureDesc& desc,
                    const VkImageCreateInfo& info) {
  VkImageFormatProperties have = {};
  const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
      context.physical().handle, info.format, info.imageType, info.tiling, info.usage, info.flags,
      &have);
  const std::string what =
      "'" + desc.label + "', " + std::string(rhi::formatInfo(desc.format).name);
  check(result, "vkGetPhysicalDeviceImageFormatProperties", what + " with these uses");
  auto refuse = [&](const std::string& why, const char* code = "VK_ERROR_FORMAT_NOT_SUPPORTED") {
    throw rhi::Error("createTexture", code, what + ": " + why);
  };
  if (info.extent.width > have.maxExtent.width || info.extent.height > have.maxExtent.height ||
      info.extent.depth > have.maxExtent.depth)
    refuse("larger than this device allows", rhi::kTooLarge);
  if (info.arrayLayers > have.maxArrayLayers) refuse("too many layers", rhi::kTooLarge);
  if (rhi::textureBytes(desc) > have.maxResourceSize)
    refuse(std::to_string(rhi::textureBytes(desc)) + " bytes, expected at most " +
               std::to_string(have.maxResourceSize) + " a texture",
           rhi::kTooLarge);
  if (info.mipLevels > have.maxMipLevels) refuse("too many mips");
  if (!(have.sampleCounts & info.samples))
    refuse(std::to_string(desc.samples) + " samples are not supported");
}

}  // namespace

ViewRange Texture::resolve(const rhi::TextureView& view) const {
  ViewRange range = {view.baseMip, view.mipCount, view.baseLayer, view.layerCount};
  if (range.mipCount == rhi::kAllRemaining) range.mipCount = desc.mips - range.baseMip;
  if (range.layerCount == rhi::kAllRemaining) range.layerCount = desc.layers - range.baseLayer;
  assert(range.baseMip + range.mipCount <= desc.mips);
  assert(range.baseLayer + range.layerCount <= desc.layers);
  return range;
}

Texture createTexture(const Context& context, Memory& memory, const rhi::TextureDesc& desc) {
  const bool volume = desc.kind == rhi::TextureKind::Tex3D;
  assert(volume || desc.depth == 1);
  assert(desc.kind == rhi::TextureKind::Tex2DArray || desc.layers == 1);
  Texture texture;
  texture.desc = desc;
  texture.aspects = aspectsOf(desc.format);
  texture.restLayout = restLayoutOf(desc);
  texture.states.resize(size_t(desc.mips) * desc.layers);
  const VkImageCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
      .imageType = volume ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D,
      .format = toVk(desc.format),
      .extent = {desc.width, desc.height, desc.depth},
      .mipLevels = desc.mips,
      .arrayLayers = desc.layers,
      .samples = VkSampleCountFlagBits(desc.samples),
      .tiling = VK_IMAGE_TILING_OPTIMAL,
      .usage = usageOf(desc),
      .initialLayout = VK_IMAGE_LAYOUT_UNDEFINED,
  };
  requireSupport(context, desc, info);
  check(context.vk.vkCreateImage(context.device, &info, nullptr, &texture.image), "vkCreateImage",
        desc.label);
  try {
    VkMemoryRequirements needs;
    context.vk.vkGetImageMemoryRequirements(context.device, texture.image, &needs);
    texture.allocation = memory.allocate(needs, MemoryKind::Device, true, desc.label);
    check(context.vk.vkBindImageMemory(context.device, texture.image, texture.allocation.memory,
                                       texture.allocation.offset),
          "vkBindImageMemory", desc.label);
  } catch (...) {
    destroyTexture(context, memory, texture);
    throw;
  }
  context.name(texture.image, VK_OBJECT_TYPE_IMAGE, desc.label);
  return texture;
}

void destroyTexture(const Context& context, Memory& memory, const Texture& texture) {
  for (const auto& cached : texture.views)
    context.vk.vkDestroyImageView(context.device, cached.view, nullptr);
  context.vk.vkDestroyImage(context.device, texture.image, nullptr);
  memory.free(texture.allocation);
}

VkImageView viewOf(const Context& context, Texture& texture, const ViewRange& range,
                   VkImageAspectFlags aspects) {
  for (const auto& cached : texture.views)
    if (cached.range == range && cached.aspects == aspects) return cached.view;
  static constexpr VkImageViewType kTypes[] = {VK_IMAGE_VIEW_TYPE_2D, VK_IMAGE_VIEW_TYPE_2D_ARRAY,
                                               VK_IMAGE_VIEW_TYPE_3D};
  const VkImageViewCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
      .image = texture.image,
      .viewType = kTypes[size_t(texture.desc.kind)],
      .format = toVk(texture.desc.format),
      .subresourceRange = {aspects, range.baseMip, range.mipCount, range.baseLayer,
                           range.layerCount},
  };
  VkImageView view = VK_NULL_HANDLE;
  check(context.vk.vkCreateImageView(context.device, &info, nullptr, &view), "vkCreateImageView",
        texture.desc.label);
  context.name(view, VK_OBJECT_TYPE_IMAGE_VIEW, texture.desc.label);
  texture.views.push_back({range, aspects, view});
  return view;
}

}  // namespace vulkan
