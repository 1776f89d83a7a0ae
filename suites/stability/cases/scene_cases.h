// Parts of the generic properties of a user's scene (scene_cases.cpp).
#pragma once

#include "suites/stability/case.h"

namespace sb {

/// The technique's own settings, at the size asked for.
inline ProbeOptions sceneOptions(const CaseContext& context) {
  return {.knobs = {}, .size = context.size};
}

Found sceneCorners(const CaseContext& context);  ///< G10
Found sceneGrazing(const CaseContext& context);  ///< G11

}  // namespace sb
