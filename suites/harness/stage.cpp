#include "suites/harness/stage.h"

#include "suites/scenes/analysis/analysis.h"
#include "techniques/render/registry.h"

namespace sb {

RendererDesc rendererDesc(const std::string& technique, const std::string& transparency,
                          const std::map<std::string, std::string>& knobs, rhi::Extent2D size,
                          uint32_t seed) {
  const ShadowEntry& shadows = shadowTechnique(technique);
  const TransparencyEntry& surfaces = transparencyTechnique(transparency);
  return {.technique = &shadows,
          .transparency = &surfaces,
          .knobs = Knobs::resolve(knobsOf(shadows.info, surfaces.info), knobs),
          .size = size,
          .seed = seed,
          .forced = {}};
}

RendererDesc rendererDesc(const CellId& id) {
  return rendererDesc(id.technique, id.transparency, id.knobs, {id.width, id.height}, id.seed);
}

Stage::Stage(const Scene& scene, rhi::Extent2D size)
    : m_scene(scene), m_effects(analyse(scene, double(size.width) / double(size.height), size.height)) {}

std::optional<rhi::Skip> Stage::unsupported(const rhi::Device& device,
                                            const RendererDesc& desc) const {
  return sb::unsupported(device, desc.technique->info, desc.transparency->info, desc.knobs,
                         m_effects.present);
}

std::unique_ptr<Renderer> Stage::renderer(const DeviceContext& device, RendererDesc desc) {
  auto& gpuScene = m_gpuScenes[&device.device];
  if (!gpuScene) gpuScene = std::make_unique<GpuScene>(device.device, m_scene);
  return std::make_unique<Renderer>(device, *gpuScene, m_effects, std::move(desc));
}

}  // namespace sb
