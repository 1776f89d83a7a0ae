// Records a frame into the queue's command buffer. Passes are in vk_pass.cpp, draws and the cache
// of what is bound in vk_draw.cpp, the rest in vk_command_list.cpp.
#pragma once

#include <array>
#include <vector>

#include "backends/rhi/command_list.h"
#include "backends/vulkan/device/vk_device.h"

namespace vulkan {

class CommandList final : public rhi::CommandList {
 public:
  explicit CommandList(Device& device)
      : m_device(device), m_context(device.context()), m_vk(device.context().vk) {}

  void begin();
  void end();

 private:
  void doBeginPass(const rhi::PassDesc& desc) override;
  void doEndPass() override;
  void doDraw(const rhi::DrawState& state, const rhi::DrawArgs& args) override;
  void doDrawIndexed(const rhi::DrawState& state,
                     std::span<const rhi::DrawIndexedArgs> draws) override;
  void doDrawIndirect(const rhi::DrawState& state, const rhi::IndirectArgs& args,
                      bool indexed) override;
  void doDispatch(const rhi::DispatchState& state, uint32_t x, uint32_t y, uint32_t z) override;
  void doDispatchIndirect(const rhi::DispatchState& state, rhi::BufferId args,
                          uint64_t offset) override;
  void doWrite(rhi::BufferId buffer, uint64_t offset, std::span<const std::byte> bytes) override;
  void doFill(rhi::BufferId buffer, uint64_t offset, uint64_t size, uint32_t word) override;
  void doCopy(rhi::BufferId source, uint64_t sourceOffset, rhi::BufferId target,
              uint64_t targetOffset, uint64_t size) override;
  void doCopy(const rhi::TextureView& source, const rhi::TextureView& target) override;
  void doTimestamp(rhi::QueryPoolId pool, uint32_t index) override;
  void doBeginQuery(rhi::QueryPoolId pool, uint32_t index) override;
  void doEndQuery(rhi::QueryPoolId pool, uint32_t index) override;

  void synchronise(const rhi::PassDesc& desc);
  void wantAttachments(const rhi::PassDesc& desc);
  void wantUse(const rhi::ResourceUse& use, bool compute);
  void beginRendering(const rhi::PassDesc& desc);
  VkRenderingAttachmentInfo colorAttachment(const rhi::ColorAttachment& color);
  VkRenderingAttachmentInfo depthAttachment(const rhi::DepthAttachment& depth);

  /// What a bind point has bound; a draw emits only what differs.
  struct Bound {
    VkPipeline pipeline = VK_NULL_HANDLE;
    const PipelineLayout* layout = nullptr;
    VkDescriptorSet set = VK_NULL_HANDLE;
    std::vector<rhi::Binding> bindings;
    std::array<uint32_t, rhi::kStorageSlotBase> offsets = {};
    std::array<size_t, rhi::kStorageSlotBase> uniformAt = {};  // index in bindings
  };
  struct BoundRaster {
    bool dynamicSet = false;
    rhi::Viewport viewport;
    VkRect2D scissor = {};
    uint8_t stencilReference = 0;
    std::array<float, 4> blendConstant = {};
    std::vector<rhi::VertexBufferBinding> vertexBuffers;
    rhi::BufferId indexBuffer;
    uint64_t indexOffset = 0;
    rhi::IndexType indexType = rhi::IndexType::Uint32;
  };
  void bindDraw(const rhi::DrawState& state, bool indexed);
  void bindResources(const Pipeline& pipeline, Bound& bound,
                     std::span<const rhi::Binding> bindings);
  bool sameContent(const Bound& bound, std::span<const rhi::Binding> bindings);
  void findSet(const Pipeline& pipeline, Bound& bound, std::span<const rhi::Binding> bindings);
  void setDynamic(const rhi::DrawState& state);
  void bindBuffers(const rhi::DrawState& state, bool indexed);

  Device& m_device;
  const Context& m_context;
  const VolkDeviceTable& m_vk;
  VkCommandBuffer m_commands = VK_NULL_HANDLE;
  Bound m_graphics;
  Bound m_compute;
  BoundRaster m_raster;
  bool m_rendering = false;
  rhi::Extent2D m_extent;  // of the current graphics pass
};

}  // namespace vulkan
