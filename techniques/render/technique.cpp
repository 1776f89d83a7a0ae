#include "techniques/render/technique.h"

namespace sb {

EffectSet representedBy(const TechniqueInfo& technique, const TechniqueInfo& transparency) {
  EffectSet represents = technique.represents | transparency.represents;
  if (technique.receiversByLayer && !transparency.handsOutLayers)
    represents.remove(Effect::TranslucentReceivers);
  return represents;
}

}  // namespace sb
