// A GpuScene seen by one camera: instance transforms relative to the eye, lights, per-draw data.
// Uploaded when the camera is set, not every frame: a frame of a standing camera uploads nothing.
#pragma once

#include "shaders/common/shared_types.h"
#include "techniques/common/camera.h"
#include "techniques/common/effects.h"
#include "techniques/common/gpu_scene.h"
#include "techniques/common/light_views.h"

namespace sb {

class SceneView {
 public:
  /// `effects` is the analysis of scene and camera; both must outlive the view.
  SceneView(rhi::Device& device, const GpuScene& gpuScene, const Effects& effects,
            rhi::Extent2D size, uint32_t seed);

  const Scene& scene() const { return m_gpu.scene(); }
  const GpuScene& gpu() const { return m_gpu; }
  const Effects& effects() const { return m_effects; }
  rhi::Extent2D size() const { return m_size; }
  double aspect() const { return double(m_size.width) / double(m_size.height); }
  uint32_t seed() const { return m_seed; }
  const CameraMatrices& camera() const { return m_camera; }

  /// Tells the shaders which shadow views belong to which light. Lights without views are lit.
  void setShadowViews(rhi::Device& device, const std::vector<LightView>& views);
  /// Other random numbers from the next frame on. Call between frames.
  void setSeed(rhi::Device& device, uint32_t seed);

  /// Slots common to every pass: draw (dynamic offset), frame, instances, materials, lights, shadow
  /// views, triangles. The draw binding is the first element.
  const std::vector<rhi::Binding>& bindings() const { return m_bindings; }
  /// Offset of the draw binding for an instance.
  uint64_t drawOffset(uint32_t instance) const { return uint64_t(instance) * m_drawStride; }
  uint64_t drawStride() const { return m_drawStride; }

 private:
  void uploadFrame(rhi::Device& device);
  void uploadLights(rhi::Device& device, const std::vector<LightView>& views);

  const GpuScene& m_gpu;
  const Effects& m_effects;
  rhi::Extent2D m_size;
  uint32_t m_seed;
  uint32_t m_lightCount = 0;  ///< that touch the view
  CameraMatrices m_camera;
  uint64_t m_drawStride = 256;
  rhi::Buffer m_draws, m_frame, m_instances, m_lights, m_shadowViews;
  std::vector<rhi::Binding> m_bindings;
};

}  // namespace sb
