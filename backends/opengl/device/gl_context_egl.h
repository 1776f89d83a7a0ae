// Contexts through EGL without a window system: one per EGL device (EGL_EXT_platform_device), or
// Mesa's surfaceless platform where devices cannot be enumerated.
#pragma once

#include "backends/opengl/device/gl_context.h"

namespace opengl {

/// Throws rhi::Error when there is no libEGL or no way to a display.
std::unique_ptr<Platform> makeEglPlatform();

}  // namespace opengl
