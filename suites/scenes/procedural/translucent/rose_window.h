// A rose window as a picture: what the procedural scene "window" hangs before its light.
#pragma once

#include "techniques/scene/scene.h"

namespace sb {

/// A gothic rose of `size` x `size` texels: sRGB colour and alpha of panes between opaque black
/// lead lines (fine ones are 2 texels wide at 1024). Alpha is how much colour a pane has: 0.15 for
/// clear glass, 1 for deep ruby and cobalt.
Image roseWindowImage(uint32_t size);

}  // namespace sb
