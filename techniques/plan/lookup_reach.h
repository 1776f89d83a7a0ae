// How far around a receiver a technique looks: what its error is judged by.
#pragma once

#include <cstdint>

namespace sb {

/// Half the width of a lookup in a light's map.
struct LookupReach {
  double constant = 0;     ///< world units across the light's direction, everywhere
  double perDistance = 0;  ///< as a share of the axial distance from the light, local lights
  /// Independent yes-or-no samples that a lookup averages with equal weights; 0: none, or unequal.
  uint32_t trials = 0;
};

}  // namespace sb
