// An OpenGL context and its function table, and the platforms that make contexts (EGL, OSMesa).
// Several contexts may live in one process and thread: use() is called at every entry point and
// costs one comparison while the context stays the same.
#pragma once

#include <memory>
#include <string>

#include "backends/opengl/device/gl_functions.h"

namespace opengl {

class Context {
 public:
  virtual ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Makes this the thread's current context and returns its functions.
  const Functions& use() {
    if (s_current != this) switchTo();
    return m_gl;
  }
  const Functions& functions() const { return m_gl; }

 protected:
  Context() = default;
  virtual void activate() = 0;  ///< makes current; throws rhi::Error
  virtual void release() = 0;   ///< makes no context current
  /// For destructors of derived classes, while release() still works.
  void retire();

  Functions m_gl;

 private:
  void switchTo();
  static thread_local Context* s_current;
};

/// One way to reach OpenGL.
class Platform {
 public:
  virtual ~Platform() = default;
  virtual size_t deviceCount() const = 0;
  /// What is known about a device before it has a context, for messages.
  virtual std::string deviceName(size_t index) const = 0;
  /// An OpenGL 4.5 core context without any surface. Throws rhi::Error with the reason.
  virtual std::unique_ptr<Context> createContext(size_t index, bool debug) = 0;
};

/// dlopen, or an Error that says what is missing. Never closed: drivers leave threads and
/// thread-local destructors behind.
void* openLibrary(const char* name, const char* purpose);
/// dlsym, or an Error.
void* librarySymbol(void* library, const char* name);

}  // namespace opengl
