#include "techniques/volumes/volume_technique.h"

#include "techniques/render/registry.h"

namespace sb {

void VolumeTechnique::prepare(const Context& context) {
  m_context.emplace(context);
  const Choices choices = choose(context);
  uint32_t mostSlots = 0, mostInView = 0;
  m_volumes.emplace(context, choices.builder, choices.volumes, choices.culling,
                    [&](const std::vector<LightVolumes>& lights) {
                      mostSlots = std::max(mostSlots, slotCount(lights));
                      mostInView = std::max(mostInView, uint32_t(slots(lights).size()));
                      visit(lights);
                    });
  if (mostSlots == 0) return;
  m_mask.emplace(context, maskKind(), mostSlots, mostInView);
  prepareShadows();
  if (context.view.steps() > 1) return;  // each frame writes its own
  write([&](rhi::BufferId buffer, std::span<const std::byte> bytes) {
    context.device.upload(buffer, 0, bytes);
  });
}

void VolumeTechnique::moved(Frame& frame) {
  m_volumes->moved(frame);
  if (!m_mask) return;
  write([&](rhi::BufferId buffer, std::span<const std::byte> bytes) {
    frame.commands().write(buffer, 0, bytes);
  });
}

void VolumeTechnique::write(const ShadowMask::Write& write) {
  m_mask->assign(slots(m_volumes->lights()), write);
  writeStep(write);
}

VisibilityInputs VolumeTechnique::inputs() const {
  // Translucent casters alone throw no shadow here.
  if (!m_mask)
    return {
        .bindings = {}, .reads = {}, .constants = {}, .folder = baselineTechnique().info.folder};
  return m_mask->inputs();
}

}  // namespace sb
