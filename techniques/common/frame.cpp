#include "techniques/common/frame.h"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace sb {
namespace {

double clockMs(clockid_t id) {
  timespec t{};
  clock_gettime(id, &t);
  return double(t.tv_sec) * 1e3 + double(t.tv_nsec) * 1e-6;
}

/// Stamps around a plain frame perturb OpenGL on software devices, where each is a glFinish.
bool frameStampsAreFree(const rhi::Device& device) {
  return device.info().limits.timestampBits > 0 &&
         !(device.isSoftware() && device.info().backend.starts_with("opengl"));
}

}  // namespace

FrameQueries::FrameQueries(rhi::Device& device) { grow(device, 255); }

void FrameQueries::grow(rhi::Device& device, uint32_t passes) {
  m_capacity = passes;
  m_stamps = device.createQueryPool(
      {.label = "frame stamps", .kind = rhi::QueryKind::Timestamp, .count = passes + 1});
  if (device.supports(rhi::Feature::PipelineStatistics))
    m_statistics = device.createQueryPool(
        {.label = "frame statistics", .kind = rhi::QueryKind::PipelineStatistics, .count = passes});
}

Frame::Frame(rhi::CommandList& commands, FrameQueries& queries, FrameMode mode)
    : m_commands(commands), m_queries(queries), m_mode(mode) {}

void Frame::pass(const rhi::PassDesc& desc, PassGroup group,
                 const std::function<void(rhi::CommandList&)>& body) {
  const uint32_t index = uint32_t(m_passes.size());
  const bool hasQuery = index < m_queries.capacity();
  const rhi::Counters before = m_commands.counters();
  {
    rhi::PassScope scope = m_commands.beginPass(desc);
    const bool count =
        m_mode == FrameMode::Counted && m_queries.hasStatistics() && !desc.compute && hasQuery;
    if (count) m_commands.beginQuery(m_queries.statistics(), index);
    body(m_commands);
    if (count) m_commands.endQuery(m_queries.statistics(), index);
  }
  if (m_mode == FrameMode::Stamped && hasQuery) m_commands.timestamp(m_queries.stamps(), index + 1);
  m_passes.push_back({.label = desc.label,
                      .group = group,
                      .counters = m_commands.counters() - before,
                      .ms = {},
                      .fragments = {}});
}

void Frame::between(const std::string& label, PassGroup group,
                    const std::function<void(rhi::CommandList&)>& body) {
  const uint32_t index = uint32_t(m_passes.size());
  body(m_commands);
  if (m_mode == FrameMode::Stamped && index < m_queries.capacity())
    m_commands.timestamp(m_queries.stamps(), index + 1);
  m_passes.push_back({.label = label, .group = group, .counters = {}, .ms = {}, .fragments = {}});
}

FrameResult FrameRunner::run(FrameMode mode, const std::function<void(Frame&)>& record) {
  FrameResult result = runOnce(mode, record);
  if (mode == FrameMode::Plain || result.passes.size() <= m_queries.capacity()) return result;
  m_queries.grow(m_device, uint32_t(result.passes.size()));
  return runOnce(mode, record);
}

FrameResult FrameRunner::runOnce(FrameMode mode, const std::function<void(Frame&)>& record) {
  FrameResult result;
  const bool frameStamps = mode == FrameMode::Plain && frameStampsAreFree(m_device);
  const double wall0 = clockMs(CLOCK_MONOTONIC);
  const double cpu0 = clockMs(CLOCK_PROCESS_CPUTIME_ID);
  const double thread0 = clockMs(CLOCK_THREAD_CPUTIME_ID);
  rhi::FrameScope scope(m_device);
  rhi::CommandList& commands = scope.commands();
  Frame frame(commands, m_queries, mode);
  if (frameStamps || mode == FrameMode::Stamped) commands.timestamp(m_queries.stamps(), 0);
  record(frame);
  if (frameStamps) commands.timestamp(m_queries.stamps(), 1);
  result.recordMs = clockMs(CLOCK_THREAD_CPUTIME_ID) - thread0;
  result.counters = commands.counters();
  const double submit0 = clockMs(CLOCK_MONOTONIC);
  const rhi::Ticket ticket = scope.end();
  result.submitMs = clockMs(CLOCK_MONOTONIC) - submit0;
  m_device.wait(ticket);
  result.wallMs = clockMs(CLOCK_MONOTONIC) - wall0;
  result.cpuMs = clockMs(CLOCK_PROCESS_CPUTIME_ID) - cpu0;

  result.passes = std::move(frame.m_passes);
  const uint32_t passes = std::min(uint32_t(result.passes.size()), m_queries.capacity());
  if (frameStamps) {
    const auto t = m_device.readQueries(m_queries.stamps(), 0, 2);
    result.deviceMs = double(t[1] - t[0]) * 1e-6;
  }
  if (mode == FrameMode::Stamped && passes > 0) {
    const auto t = m_device.readQueries(m_queries.stamps(), 0, passes + 1);
    for (uint32_t i = 0; i < passes; ++i) result.passes[i].ms = double(t[i + 1] - t[i]) * 1e-6;
    result.stampedMs = double(t[passes] - t[0]) * 1e-6;
  }
  if (mode == FrameMode::Counted && m_queries.hasStatistics())
    for (uint32_t i = 0; i < passes; ++i)
      if (result.passes[i].counters.passes > 0 && result.passes[i].counters.dispatches == 0)
        result.passes[i].fragments = m_device.readQueries(m_queries.statistics(), i, 1)[5];
  return result;
}

}  // namespace sb
