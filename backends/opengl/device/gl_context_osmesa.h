// Contexts through OSMesa: Mesa's software rasteriser as a plain library, drawing to memory.
#pragma once

#include "backends/opengl/device/gl_context.h"

namespace opengl {

/// Throws rhi::Error when there is no libOSMesa.
std::unique_ptr<Platform> makeOsmesaPlatform();

}  // namespace opengl
