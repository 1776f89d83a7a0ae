#include "techniques/plan/plan.h"

namespace sb {

Plan makePlan(const Effects& effects, EffectSet represents, EffectSet forced) {
  Plan plan;
  plan.forced = (forced & represents) - effects.present;
  plan.planned = (effects.present & represents) | plan.forced;
  for (Effect e : (represents - plan.planned).list()) {
    auto reason = effects.reason.find(e);
    plan.skipped.emplace_back(e, reason == effects.reason.end() ? "" : reason->second);
  }
  plan.unrepresented = (effects.present - represents).list();
  return plan;
}

}  // namespace sb
