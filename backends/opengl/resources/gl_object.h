// Owns one GL name; the RAII of every object class of this backend. Its context must be current
// when it is destroyed, which Device sees to.
#pragma once

#include <utility>

#include "backends/opengl/device/gl_functions.h"

namespace opengl {

class UniqueName {
 public:
  using Destroy = void (*)(const Functions&, GLuint);

  UniqueName() = default;
  UniqueName(const Functions& gl, GLuint name, Destroy destroy)
      : m_gl(&gl), m_name(name), m_destroy(destroy) {}
  UniqueName(UniqueName&& other) noexcept
      : m_gl(other.m_gl), m_name(std::exchange(other.m_name, 0)), m_destroy(other.m_destroy) {}
  UniqueName& operator=(UniqueName&& other) noexcept {
    std::swap(m_gl, other.m_gl);
    std::swap(m_name, other.m_name);
    std::swap(m_destroy, other.m_destroy);
    return *this;
  }
  ~UniqueName() {
    if (m_name) m_destroy(*m_gl, m_name);
  }
  GLuint get() const { return m_name; }

 private:
  const Functions* m_gl = nullptr;
  GLuint m_name = 0;
  Destroy m_destroy = nullptr;
};

}  // namespace opengl
