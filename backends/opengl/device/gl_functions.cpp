#include "backends/opengl/device/gl_functions.h"

#include "backends/rhi/error.h"

namespace opengl {

Functions loadFunctions(const std::function<void*(const char*)>& resolve) {
  Functions table;
  std::string missing;
  auto load = [&](auto& pointer, const char* name) {
    void* address = resolve(name);
    if (!address) missing += (missing.empty() ? "" : ", ") + std::string(name);
    pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(address);
  };
#define OPENGL_LOAD(name) load(table.name, "gl" #name);
  OPENGL_FUNCTIONS(OPENGL_LOAD)
#undef OPENGL_LOAD
  if (!missing.empty())
    throw rhi::Error("loading OpenGL 4.5 functions", "", "the driver lacks " + missing);
  return table;
}

std::string errorName(GLenum code) {
  switch (code) {
    case GL_NO_ERROR:
      return "GL_NO_ERROR";
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST:
      return "GL_CONTEXT_LOST";
    default:
      return "GL error " + std::to_string(code);
  }
}

void clearErrors(const Functions& gl) {
  // Bounded: a lost context answers GL_CONTEXT_LOST for ever.
  for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
  }
}

void throwOnError(const Functions& gl, const char* call, const std::string& detail) {
  if (const GLenum code = gl.GetError(); code != GL_NO_ERROR) {
    clearErrors(gl);
    throw rhi::Error(call, errorName(code), detail);
  }
}

}  // namespace opengl
