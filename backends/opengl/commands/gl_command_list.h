// Executes commands at once: OpenGL records by itself.
#pragma once

#include "backends/opengl/commands/gl_barriers.h"
#include "backends/opengl/commands/gl_state.h"
#include "backends/opengl/device/gl_context.h"
#include "backends/opengl/resources/gl_framebuffer.h"
#include "backends/rhi/command_list.h"

namespace opengl {

class CommandList : public rhi::CommandList {
 public:
  CommandList(Context& context, Objects& objects, State& state, FramebufferCache& framebuffers,
              Barriers& barriers);

 protected:
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

  friend class Device;
  /// Closes the pass and the query that are open; nothing is resolved.
  void abandon();

 private:
  struct Resolve {
    rhi::TextureView source, target;
  };
  void clear(GLuint framebuffer, const rhi::PassDesc& desc);
  bool hasStencil(const rhi::DepthAttachment& depth) const;
  void resolve(const Resolve& resolve);

  Context& m_context;
  Objects& m_objects;
  State& m_state;
  FramebufferCache& m_framebuffers;
  Barriers& m_barriers;

  // Of the pass under way.
  std::vector<Resolve> m_resolves;
  std::vector<GLenum> m_discards;  ///< attachments whose contents may go at its end
  GLuint m_framebuffer = 0;
  bool m_grouped = false;  ///< within a debug group
  rhi::QueryPoolId m_query;  ///< open
  uint32_t m_queryIndex = 0;
};

}  // namespace opengl
