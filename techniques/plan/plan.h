// From what a scene calls for and what a technique can represent follows what is executed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "techniques/plan/effects.h"

namespace sb {

/// Decided once per cell; techniques create and record only what `runs(...)`.
struct Plan {
  EffectSet planned;  ///< present and represented (or forced): their passes, branches, samples exist
  EffectSet forced;   ///< executed although the scene does not call for them (proof of skipping)
  std::vector<std::pair<Effect, std::string>> skipped;  ///< represented, not called for: why
  std::vector<Effect> unrepresented;                    ///< called for, not represented

  bool runs(Effect effect) const { return planned.has(effect); }
};

/// `represents`: of the techniques that draw the cell together. `forced` (tests
/// only) plans effects that the scene lacks; the picture must not change (index 00, skip planner).
Plan makePlan(const Effects& effects, EffectSet represents, EffectSet forced = {});

}  // namespace sb
