#include "backends/opengl/device/gl_context.h"

#include <dlfcn.h>

#include "backends/rhi/error.h"

namespace opengl {

thread_local Context* Context::s_current = nullptr;

Context::~Context() = default;

void Context::switchTo() {
  // The previous context is released by its own platform first: Mesa's EGL and OSMesa share one
  // dispatch slot per thread without knowing of each other, and EGL would take a later request for
  // the context it believes current as already fulfilled.
  if (s_current) s_current->release();
  s_current = nullptr;
  activate();
  s_current = this;
}

void Context::retire() {
  if (s_current == this) {
    release();
    s_current = nullptr;
  }
}

void* openLibrary(const char* name, const char* purpose) {
  if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
  const char* reason = dlerror();
  throw rhi::Error("dlopen", "",
                   std::string(purpose) + " needs " + name + ", which cannot be opened (" +
                       (reason ? reason : "no reason given") + ")");
}

void* librarySymbol(void* library, const char* name) {
  if (void* address = dlsym(library, name)) return address;
  throw rhi::Error("dlsym", "", std::string("the library has no function ") + name);
}

}  // namespace opengl
