// Which glMemoryBarrier bits a pass or a transfer needs. OpenGL orders everything by itself except
// what shaders store to buffers and images; so only passes that declared StorageWrite leave
// anything behind, and each kind of access is made current once, when it is first needed.
#pragma once

#include "backends/opengl/device/gl_functions.h"
#include "backends/rhi/desc.h"

namespace opengl {

class Barriers {
 public:
  explicit Barriers(const Functions& gl) : m_gl(gl) {}

  void beginPass(const rhi::PassDesc& pass);
  void endPass();
  /// Before transfers: GL_BUFFER_UPDATE_BARRIER_BIT or GL_TEXTURE_UPDATE_BARRIER_BIT.
  void before(GLbitfield bits);

 private:
  const Functions& m_gl;
  GLbitfield m_stale = 0;  ///< kinds of access that would not yet see the last stores
  bool m_passSinceBarrier = false;
  bool m_storing = false;  ///< the current pass declared StorageWrite
};

}  // namespace opengl
