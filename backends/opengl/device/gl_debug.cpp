#include "backends/opengl/device/gl_debug.h"

#include <algorithm>
#include <string>

#include "backends/rhi/device.h"

namespace opengl {
namespace {

const char* typeName(GLenum type) {
  switch (type) {
    case GL_DEBUG_TYPE_ERROR:
      return "error";
    case GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR:
      return "deprecated";
    case GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR:
      return "undefined";
    case GL_DEBUG_TYPE_PORTABILITY:
      return "portability";
    case GL_DEBUG_TYPE_PERFORMANCE:
      return "performance";
    default:
      return "other";
  }
}

void APIENTRY onMessage(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei length,
                        const GLchar* text, const void* user) {
  // Notifications are chatter by definition: groups entered and left (our own), where NVIDIA put a
  // buffer. Everything else but performance is reported.
  // Hints (llvmpipe tells of every shader variant it compiles) are no defects.
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION || type == GL_DEBUG_TYPE_PERFORMANCE) return;
  auto* device = const_cast<rhi::Device*>(static_cast<const rhi::Device*>(user));
  device->report({.source = "opengl",
                  .rule = std::string(typeName(type)) + " " + std::to_string(id),
                  .text = length < 0 ? std::string(text) : std::string(text, size_t(length))});
}

// The least maximum the specification allows for labels and messages; longer ones are an error.
constexpr size_t kMaxLabel = 255;

}  // namespace

void enableDebugOutput(const Functions& gl, rhi::Device& device) {
  gl.Enable(GL_DEBUG_OUTPUT);
  gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  gl.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  gl.DebugMessageCallback(onMessage, &device);
}

void labelObject(const Functions& gl, GLenum kind, GLuint name, std::string_view label) {
  gl.ObjectLabel(kind, name, GLsizei(std::min(label.size(), kMaxLabel)), label.data());
}

void pushGroup(const Functions& gl, std::string_view label) {
  gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, GLsizei(std::min(label.size(), kMaxLabel)),
                    label.data());
}

void popGroup(const Functions& gl) { gl.PopDebugGroup(); }

}  // namespace opengl
