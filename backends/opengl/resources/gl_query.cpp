#include "backends/opengl/resources/gl_query.h"

#include <cassert>

namespace opengl {
namespace {

// ARB_pipeline_statistics_query; <GL/glcorearb.h> has the names of OpenGL 4.6. The order is that of
// Device::readQueries.
const std::vector<GLenum> kStatistics = {
    GL_VERTICES_SUBMITTED,        GL_PRIMITIVES_SUBMITTED,       GL_VERTEX_SHADER_INVOCATIONS,
    GL_CLIPPING_INPUT_PRIMITIVES, GL_CLIPPING_OUTPUT_PRIMITIVES, GL_FRAGMENT_SHADER_INVOCATIONS,
    GL_COMPUTE_SHADER_INVOCATIONS};

}  // namespace

QueryPool::QueryPool(const Functions& gl, const rhi::QueryPoolDesc& desc, bool software)
    : m_gl(&gl), m_desc(desc) {
  switch (desc.kind) {
    case rhi::QueryKind::Timestamp:
      if (software)
        m_hostTimes.resize(desc.count);
      else
        m_targets = {GL_TIMESTAMP};
      break;
    case rhi::QueryKind::Occlusion:
      m_targets = {GL_SAMPLES_PASSED};
      break;
    case rhi::QueryKind::PipelineStatistics:
      m_targets = kStatistics;
      break;
  }
  // Not glCreateQueries: Mesa 22 refuses the targets of pipeline statistics there, though it takes
  // them in glBeginQuery.
  for (size_t i = 0; i < desc.count * m_targets.size(); ++i) {
    GLuint name = 0;
    gl.GenQueries(1, &name);
    m_names.emplace_back(gl, name, [](const Functions& f, GLuint n) { f.DeleteQueries(1, &n); });
  }
}

void QueryPool::timestamp(uint32_t index) {
  assert(m_desc.kind == rhi::QueryKind::Timestamp && index < m_desc.count);
  if (m_hostTimes.empty()) {
    m_gl->QueryCounter(m_names[index].get(), GL_TIMESTAMP);
    return;
  }
  m_gl->Finish();
  GLint64 now = 0;
  m_gl->GetInteger64v(GL_TIMESTAMP, &now);
  m_hostTimes[index] = uint64_t(now);
}

void QueryPool::begin(uint32_t index) {
  assert(m_desc.kind != rhi::QueryKind::Timestamp && index < m_desc.count);
  for (size_t i = 0; i < m_targets.size(); ++i)
    m_gl->BeginQuery(m_targets[i], m_names[index * m_targets.size() + i].get());
}

void QueryPool::end(uint32_t) {
  assert(m_desc.kind != rhi::QueryKind::Timestamp && index < m_desc.count);
  for (GLenum target : m_targets) m_gl->EndQuery(target);
}

void QueryPool::read(uint32_t first, uint32_t count, std::span<uint64_t> out) const {
  assert(first + count <= m_desc.count);
  if (!m_hostTimes.empty()) {
    for (uint32_t i = 0; i < count; ++i) out[i] = m_hostTimes[first + i];
    return;
  }
  const size_t values = m_targets.size();
  for (size_t i = 0; i < count * values; ++i) {
    GLuint64 value = 0;
    m_gl->GetQueryObjectui64v(m_names[first * values + i].get(), GL_QUERY_RESULT, &value);
    out[i] = value;
  }
}

}  // namespace opengl
