// The OpenGL 4.5 core backend: through EGL (any vendor, no window system) or through OSMesa (Mesa's
// software rasteriser as a library, for machines without a usable EGL).
// Both libraries are opened at run time; a machine without them merely lacks the backend.
#pragma once

#include <memory>

#include "backends/rhi/device.h"

namespace opengl {

enum class ContextKind { Egl, OSMesa };

/// Never fails: a missing library or driver is reported by enumerate() and open().
std::unique_ptr<rhi::Backend> makeBackend(ContextKind kind);

}  // namespace opengl
