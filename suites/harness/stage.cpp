#include "suites/harness/stage.h"

#include "suites/scenes/analysis/analysis.h"
#include "techniques/render/registry.h"

namespace sb {

RendererDesc rendererDesc(const CellId& id) {
  return {.technique = &shadowTechnique(id.technique),
          .transparency = &transparencyTechnique(id.transparency),
          .lights = &lightTechnique(id.lights),
          .knobs = cellKnobs(id),
          .size = {id.width, id.height},
          .seed = id.seed,
          .forced = {}};
}

Stage::Stage(const Scene& scene, rhi::Extent2D size)
    : m_scene(scene), m_effects(analyse(scene, double(size.width) / double(size.height), size.height)) {}

std::optional<rhi::Skip> Stage::unsupported(const rhi::Device& device,
                                            const RendererDesc& desc) const {
  return sb::unsupported(device, desc.set(), desc.knobs, m_effects.present);
}

std::unique_ptr<Renderer> Stage::renderer(const DeviceContext& device, RendererDesc desc) {
  auto& gpuScene = m_gpuScenes[&device.device];
  if (!gpuScene) gpuScene = std::make_unique<GpuScene>(device.device, m_scene);
  return std::make_unique<Renderer>(device, *gpuScene, m_effects, std::move(desc));
}

}  // namespace sb
