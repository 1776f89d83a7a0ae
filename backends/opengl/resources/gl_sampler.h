// A sampler object.
#pragma once

#include "backends/opengl/resources/gl_object.h"
#include "backends/rhi/desc.h"

namespace opengl {

class Sampler {
 public:
  Sampler(const Functions& gl, const rhi::SamplerDesc& desc);
  GLuint name() const { return m_name.get(); }

 private:
  UniqueName m_name;
};

}  // namespace opengl
