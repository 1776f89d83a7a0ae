// Synchronization. A pass collects what it wants of each buffer and image part; flush turns that
// into one vkCmdPipelineBarrier2. Transfers synchronise by themselves: a run of them stands between
// two full barriers, so that no pass needs to declare what they wrote.
#pragma once

#include <vector>

#include "backends/vulkan/resources/vk_texture.h"

namespace vulkan {

class Barriers {
 public:
  explicit Barriers(const Context& context) : m_context(context) {}

  /// A new image: comes to its rest layout before the next commands.
  void created(Texture& texture) { m_new.push_back(&texture); }
  void forget(const Texture& texture);
  void forget(const Buffer& buffer);

  /// States that a frame changes are as they were before when it is abandoned: nothing of what was
  /// recorded has happened.
  void beginFrame();
  void endFrame();
  void abandonFrame();

  void want(Buffer& buffer, VkPipelineStageFlags2 stages, VkAccessFlags2 access, bool write);
  /// With `discard` the old contents may be lost.
  void want(Texture& texture, const ViewRange& range, VkPipelineStageFlags2 stages,
            VkAccessFlags2 access, bool write, VkImageLayout layout, bool discard);
  void flush(VkCommandBuffer commands);

  /// Before a transfer that touches these buffers (null: none).
  void beginTransfer(VkCommandBuffer commands, Buffer* first, Buffer* second);
  /// Ends a run of transfers; everything before is visible to everything after. Without a run, does
  /// nothing.
  void endTransfers(VkCommandBuffer commands);
  /// Around a transfer of an image part, inside a run.
  void toTransfer(VkCommandBuffer commands, Texture& texture, const ViewRange& range,
                  VkImageLayout layout);
  void toRest(VkCommandBuffer commands, Texture& texture, const ViewRange& range);

  /// Everything before is finished and visible before anything after starts.
  void full(VkCommandBuffer commands);

 private:
  struct Want {
    Buffer* buffer = nullptr;
    Texture* texture = nullptr;
    uint32_t mip = 0;
    uint32_t layer = 0;
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
    bool write = false;
    bool discard = false;
  };
  struct Scope {
    VkPipelineStageFlags2 sourceStages = 0;
    VkAccessFlags2 sourceAccess = 0;
    VkPipelineStageFlags2 stages = 0;
    VkAccessFlags2 access = 0;
  };
  /// Merges with what this batch already wants of the same thing.
  void add(AccessState& state, const Want& want);
  static bool plan(AccessState& state, const Want& want, bool layoutChanges, Scope& scope);
  void append(const Want& want, const Scope& scope, VkImageLayout from);
  void initialise(VkCommandBuffer commands);
  void emit(VkCommandBuffer commands, std::span<const VkMemoryBarrier2> memory,
            std::span<const VkBufferMemoryBarrier2> buffers,
            std::span<const VkImageMemoryBarrier2> images);
  static VkImageMemoryBarrier2 image(const Texture& texture, const ViewRange& range,
                                     const Scope& scope, VkImageLayout from, VkImageLayout to);

  const Context& m_context;
  std::vector<Texture*> m_new;
  std::vector<Want> m_wants;
  std::vector<VkBufferMemoryBarrier2> m_buffers;
  std::vector<VkImageMemoryBarrier2> m_images;
  uint32_t m_batch = 1;
  bool m_transferring = false;

  /// What a frame has changed, in order; of parts of images and of buffers.
  struct Change {
    Buffer* buffer = nullptr;
    Texture* texture = nullptr;
    SubresourceState* part = nullptr;
    SubresourceState before;
  };
  void remember(Buffer& buffer);
  void remember(Texture& texture, SubresourceState& part);
  bool m_inFrame = false;
  std::vector<Change> m_changes;
  std::vector<Texture*> m_initialised;  // in this frame
  std::vector<const Buffer*> m_touched;  // since the last barrier within the run
};

}  // namespace vulkan
