#include "techniques/render/technique.h"

namespace sb {

EffectSet representedBy(const TechniqueSet& set) {
  EffectSet represents;
  for (const TechniqueInfo* info : set.all()) represents = represents | info->represents;
  if (set.shadow->receiversByLayer && !set.transparency->handsOutLayers)
    represents.remove(Effect::TranslucentReceivers);
  return represents;
}

std::vector<KnobInfo> knobsOf(const TechniqueSet& set) {
  std::vector<KnobInfo> knobs;
  for (const TechniqueInfo* info : set.all())
    knobs.insert(knobs.end(), info->knobs.begin(), info->knobs.end());
  return knobs;
}

std::optional<rhi::Skip> unsupported(const rhi::Device& device, const TechniqueSet& set,
                                     const Knobs& knobs, EffectSet present) {
  const TechniqueInfo &shadow = *set.shadow, &transparency = *set.transparency;
  if (shadow.drawsInParts && shadow.drawsInParts(knobs) &&
      !(transparency.drawsParts && transparency.drawsParts(knobs)))
    return rhi::Skip{shadow.name + " makes shadow maps between translucent surfaces here, and " +
                     transparency.name + " does not draw those one after another"};
  for (const TechniqueInfo* info : set.all())
    if (const std::string why = info->refuses ? info->refuses(knobs) : ""; !why.empty())
      return rhi::Skip{info->name + ": " + why};
  if (shadow.receiversByLayer && !device.formatCaps(rhi::Format::D32FloatS8).depthTarget)
    return rhi::Skip{"the device has no depth targets of D32F with stencil"};
  // Persistent triangle keys need gl_PrimitiveID, which Vulkan ties to geometry shaders (spec 03,
  // P2).
  std::vector<rhi::Feature> needed = {rhi::Feature::GeometryShader};
  for (const TechniqueInfo* info : set.all()) {
    needed.insert(needed.end(), info->requires_.begin(), info->requires_.end());
    for (const auto& [effect, feature] : info->requiresFor)
      if (present.has(effect) && !device.supports(feature))
        return rhi::Skip{"the device lacks " + std::string(rhi::featureName(feature)) + ", which " +
                         info->name + " needs for " + std::string(effectName(effect))};
  }
  for (rhi::Feature feature : needed)
    if (!device.supports(feature))
      return rhi::Skip{"the device lacks " + std::string(rhi::featureName(feature))};
  return {};
}

}  // namespace sb
