// A pool of queries. Timestamps on software devices are taken by the host after glFinish, because
// llvmpipe answers a query from within the bins of its scene and misses most of the work
// (facts.md).
#pragma once

#include <span>
#include <vector>

#include "backends/opengl/resources/gl_object.h"
#include "backends/rhi/desc.h"

namespace opengl {

class QueryPool {
 public:
  QueryPool(const Functions& gl, const rhi::QueryPoolDesc& desc, bool software);

  const rhi::QueryPoolDesc& desc() const { return m_desc; }
  void timestamp(uint32_t index);
  void begin(uint32_t index);
  void end(uint32_t index);
  /// Blocks until the results are there.
  void read(uint32_t first, uint32_t count, std::span<uint64_t> out) const;

 private:
  const Functions* m_gl;
  rhi::QueryPoolDesc m_desc;
  std::vector<GLenum> m_targets;    ///< queries that one index of the pool stands for
  std::vector<UniqueName> m_names;  ///< index-major; empty for host timestamps
  std::vector<uint64_t> m_hostTimes;
};

}  // namespace opengl
