#include "techniques/draw/frame/pass_queries.h"

namespace sb {

PassQueries::PassQueries(rhi::Device& device, const std::string& label, uint32_t most)
    : m_device(&device),
      m_pool(device.createQueryPool(
          {.label = label, .kind = rhi::QueryKind::Occlusion, .count = most})) {}

void PassQueries::count(rhi::CommandList& commands, const std::function<void()>& draws) {
  commands.beginQuery(m_pool, m_counted);
  draws();
  commands.endQuery(m_pool, m_counted);
  ++m_counted;
}

std::vector<uint64_t> PassQueries::look() const {
  if (m_counted == 0) return {};
  return m_device->readQueries(m_pool, 0, m_counted);
}

std::vector<uint64_t> PassQueries::take() {
  std::vector<uint64_t> samples = look();
  m_counted = 0;
  return samples;
}

}  // namespace sb
