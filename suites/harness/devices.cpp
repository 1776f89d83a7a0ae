#include "suites/harness/devices.h"

#include <algorithm>

#include "techniques/plan/error.h"

namespace sb {

Devices::Devices(std::vector<rhi::Backend*> backends, const rhi::ShaderLibrary& shaders,
                 rhi::DeviceRequest request)
    : m_backends(std::move(backends)), m_shaders(shaders), m_request(std::move(request)) {}

std::vector<std::string> Devices::names() const {
  std::vector<std::string> names;
  for (rhi::Backend* b : m_backends) names.emplace_back(b->name());
  return names;
}

DeviceSession* Devices::open(const std::string& backend) {
  if (auto it = m_sessions.find(backend); it != m_sessions.end()) return &it->second;
  if (m_failures.contains(backend)) return nullptr;
  auto found = std::ranges::find(m_backends, backend, [](rhi::Backend* b) { return b->name(); });
  if (found == m_backends.end()) throw InputError("", unknownName("backend", backend, names()));
  try {
    DeviceSession session;
    session.device = (*found)->open(m_request);
    if (m_request.validate) session.validator = std::make_unique<rhi::Validator>(*session.device);
    session.pipelines = std::make_unique<PipelineCache>(*session.device);
    session.queries = std::make_unique<FrameQueries>(*session.device);
    session.shaders = &m_shaders;
    return &m_sessions.emplace(backend, std::move(session)).first->second;
  } catch (const rhi::Error& e) {
    m_failures[backend] = e.what();
    if (!m_request.selector.empty() && e.call() == "device selection")
      m_unmatched += (m_unmatched.empty() ? "" : "; ") + backend + ": " + e.detail();
    return nullptr;
  }
}

std::string Devices::why(const std::string& backend) const {
  auto it = m_failures.find(backend);
  return it == m_failures.end() ? "" : it->second;
}

void Devices::lose(const std::string& backend, const std::string& reason) {
  m_lost.try_emplace(backend, "the device was lost: " + reason);
}

std::string Devices::whyLost(const std::string& backend) const {
  auto it = m_lost.find(backend);
  return it == m_lost.end() ? "" : it->second;
}

const std::vector<TimerFact>& Devices::timersOf(DeviceSession& session) {
  if (session.timers.empty()) session.timers = checkTimers(session.context());
  return session.timers;
}

std::string Devices::whyNoSuchDevice() const { return m_sessions.empty() ? m_unmatched : ""; }

}  // namespace sb
