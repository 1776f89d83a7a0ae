// What shaders know of a view beside its instances: the frame, the lights that touch it, their
// light views, surfaces that lie over others in one plane.
#pragma once

#include <vector>

#include "techniques/draw/views/buffer_write.h"

namespace sb {

class SceneView;

class ViewBuffers {
 public:
  /// Lists of lights that are longer are read from storage: what hardware keeps for constants.
  static constexpr uint64_t kMostUniformBytes = 64 * 1024;

  /// Room for `lights`, and for `coplanarWords` of coplanar surfaces (0: there never are any).
  ViewBuffers(rhi::Device& device, size_t lights, size_t coplanarWords);
  /// Makes room for so many light views.
  void makeRoom(rhi::Device& device, size_t lightViews);

  /// Slots common to every pass: frame, lights, shadow views, coplanar surfaces.
  std::vector<rhi::Binding> bindings() const;
  /// Of shaders/common/scene.glsl: how the lists are declared.
  std::vector<rhi::SpecConstant> constants() const;

  // What the view shows now.
  void writeAll(const BufferWrite& write, const SceneView& view) const;
  void writeFrame(const BufferWrite& write, const SceneView& view) const;
  void writeLights(const BufferWrite& write, const SceneView& view) const;
  void writeCoplanar(const BufferWrite& write, const SceneView& view) const;

 private:
  bool inStorage() const;

  uint64_t m_mostUniform;  ///< bytes of a list in a uniform block
  uint32_t m_lightCount, m_viewCount = 1;
  rhi::Buffer m_frame, m_lights, m_shadowViews, m_coplanar;
};

}  // namespace sb
