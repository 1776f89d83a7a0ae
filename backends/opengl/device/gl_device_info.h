// What a context's device is and can do, by query: never by assumption about a vendor, except for
// the kind of device, which OpenGL does not tell and the renderer's name must.
#pragma once

#include "backends/opengl/device/gl_functions.h"
#include "backends/rhi/device_info.h"

namespace opengl {

/// Everything except backend and index. The context must be current.
rhi::DeviceInfo queryDeviceInfo(const Functions& gl);
rhi::FormatCaps queryFormatCaps(const Functions& gl, rhi::Format format);

}  // namespace opengl
