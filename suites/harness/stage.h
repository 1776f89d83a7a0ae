// The one way from a scene to frames: analysed for the picture's shape, put once on each device
// that draws it, drawn by a technique of each kind. Cells, hard cases, `bench render` and tests go
// this way.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "suites/harness/cell.h"
#include "techniques/render/renderer.h"

namespace sb {

/// The techniques of a cell with the values of their knobs, its size and its seed. Throws
/// InputError on a bad knob.
RendererDesc rendererDesc(const CellId& id);

/// A scene made ready for all the cells of one size that draw it, on any device.
class Stage {
 public:
  /// `scene` must outlive the stage, and the stage its renderers. `size` of the pictures.
  Stage(const Scene& scene, rhi::Extent2D size);

  const Scene& scene() const { return m_scene; }
  const Effects& effects() const { return m_effects; }
  /// Why the device cannot draw the scene in this way, or nothing.
  std::optional<rhi::Skip> unsupported(const rhi::Device& device, const RendererDesc& desc) const;
  /// Outside what is timed. Throws rhi::Error when the device refuses.
  std::unique_ptr<Renderer> renderer(const DeviceContext& device, RendererDesc desc);

 private:
  const Scene& m_scene;
  const Effects m_effects;
  std::map<const rhi::Device*, std::unique_ptr<GpuScene>> m_gpuScenes;
};

}  // namespace sb
