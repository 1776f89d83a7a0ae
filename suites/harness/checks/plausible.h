// Could a time be true at all? What no device can do is a broken timer, however steady it is.
#pragma once

#include <string>

#include "suites/harness/measuring/samples.h"

namespace sb {

/// Why the times of a cell's plain frames cannot be true, or "": a frame that takes no time or
/// longer than all the wall time that was measured, or that draws, triangles or fragments went
/// through it at a rate beyond any device's (hundreds of times those of the fastest of 2026).
std::string whyImplausible(const Samples& samples, bool software);

}  // namespace sb
