// GL's debug output (KHR_debug, core since 4.3): messages to Device::report, labels and groups for
// the debuggers.
#pragma once

#include <string_view>

#include "backends/opengl/device/gl_functions.h"

namespace rhi {
class Device;
}

namespace opengl {

/// Sends the current context's messages to `device`, synchronously, so that a debugger shows the
/// call at fault. Only where validation was asked for: it costs time.
void enableDebugOutput(const Functions& gl, rhi::Device& device);

void labelObject(const Functions& gl, GLenum kind, GLuint name, std::string_view label);
void pushGroup(const Functions& gl, std::string_view label);
void popGroup(const Functions& gl);

}  // namespace opengl
