#include "techniques/draw/frame.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "backends/rhi/timestamp.h"

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

/// All stamps of a frame lie within its wall time. Clocks of device and host may differ by 1e-3.
bool stampsExceedWall(double stampsMs, double wallMs) { return stampsMs > wallMs * 1.001 + 1e-3; }

}  // namespace

FrameQueries::FrameQueries(rhi::Device& device) { grow(device, 255); }

void FrameQueries::grow(rhi::Device& device, uint32_t passes) {
  m_capacity = passes;
  if (device.info().limits.timestampBits > 0)
    m_stamps = device.createQueryPool(
        {.label = "frame stamps", .kind = rhi::QueryKind::Timestamp, .count = passes + 1});
  if (device.supports(rhi::Feature::PipelineStatistics))
    m_statistics = device.createQueryPool(
        {.label = "frame statistics", .kind = rhi::QueryKind::PipelineStatistics, .count = passes});
}

Frame::Frame(rhi::CommandList& commands, FrameQueries& queries, FrameMode mode)
    : m_commands(commands), m_queries(queries), m_mode(mode) {}

double Frame::threadMs() const {
  return m_mode == FrameMode::Stamped ? clockMs(CLOCK_THREAD_CPUTIME_ID) : 0;
}

double Frame::recordedSince(double start, size_t first) const {
  double ms = threadMs() - start;
  for (size_t i = first; i < m_passes.size(); ++i) ms -= m_passes[i].recordMs;
  return ms;
}

void Frame::pass(const rhi::PassDesc& desc, PassGroup group,
                 const std::function<void(rhi::CommandList&)>& body) {
  const uint32_t index = uint32_t(m_passes.size());
  const bool hasQuery = index < m_queries.capacity();
  const double start = threadMs();
  const rhi::Counters before = m_commands.counters();
  {
    rhi::PassScope scope = m_commands.beginPass(desc);
    const bool count =
        m_mode == FrameMode::Counted && m_queries.hasStatistics() && !desc.compute && hasQuery;
    if (count) m_commands.beginQuery(m_queries.statistics(), index);
    body(m_commands);
    if (count) m_commands.endQuery(m_queries.statistics(), index);
  }
  if (m_mode == FrameMode::Stamped && m_queries.hasStamps() && hasQuery)
    m_commands.timestamp(m_queries.stamps(), index + 1);
  m_passes.push_back({.label = desc.label,
                      .group = group,
                      .counters = m_commands.counters() - before,
                      .ms = {},
                      .recordMs = recordedSince(start, index),
                      .fragments = {}});
}

void Frame::between(const std::string& label, PassGroup group,
                    const std::function<void(rhi::CommandList&)>& body) {
  const double start = threadMs();
  const size_t first = m_passes.size();
  body(m_commands);
  // Behind what is told apart within it.
  const uint32_t index = uint32_t(m_passes.size());
  if (m_mode == FrameMode::Stamped && m_queries.hasStamps() && index < m_queries.capacity())
    m_commands.timestamp(m_queries.stamps(), index + 1);
  m_passes.push_back({.label = label,
                      .group = group,
                      .counters = {},
                      .ms = {},
                      .recordMs = recordedSince(start, first),
                      .fragments = {}});
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
  const bool passStamps = mode == FrameMode::Stamped && m_queries.hasStamps();
  const double wall0 = clockMs(CLOCK_MONOTONIC);
  const double cpu0 = clockMs(CLOCK_PROCESS_CPUTIME_ID);
  const double thread0 = clockMs(CLOCK_THREAD_CPUTIME_ID);
  rhi::FrameScope scope(m_device);
  rhi::CommandList& commands = scope.commands();
  Frame frame(commands, m_queries, mode);
  if (frameStamps || passStamps) commands.timestamp(m_queries.stamps(), 0);
  record(frame);
  if (frameStamps) commands.timestamp(m_queries.stamps(), 1);
  result.recordMs = clockMs(CLOCK_THREAD_CPUTIME_ID) - thread0;
  result.counters = commands.counters();
  const double submit0 = clockMs(CLOCK_MONOTONIC);
  const rhi::Ticket ticket = scope.end();
  result.submitMs = clockMs(CLOCK_MONOTONIC) - submit0;
  result.callsMs = clockMs(CLOCK_THREAD_CPUTIME_ID) - thread0;
  m_device.wait(ticket);
  result.wallMs = clockMs(CLOCK_MONOTONIC) - wall0;
  result.cpuMs = clockMs(CLOCK_PROCESS_CPUTIME_ID) - cpu0;

  result.passes = std::move(frame.m_passes);
  if (frameStamps || passStamps) readStamps(mode, result);
  const uint32_t passes = std::min(uint32_t(result.passes.size()), m_queries.capacity());
  if (mode == FrameMode::Counted && m_queries.hasStatistics())
    for (uint32_t i = 0; i < passes; ++i)
      if (result.passes[i].counters.passes > 0 && result.passes[i].counters.dispatches == 0)
        result.passes[i].fragments = m_device.readQueries(m_queries.statistics(), i, 1)[5];
  return result;
}

/// Times of a frame's stamps. All of them go when one is broken: which one a reset hit is unknown.
void FrameRunner::readStamps(FrameMode mode, FrameResult& result) const {
  const uint32_t spans = mode == FrameMode::Plain
                             ? 1
                             : std::min(uint32_t(result.passes.size()), m_queries.capacity());
  if (spans == 0) return;
  const rhi::Limits& limits = m_device.info().limits;
  const auto stamps = m_device.readQueries(m_queries.stamps(), 0, spans + 1);
  std::vector<double> ms(spans);
  double sum = 0;
  for (uint32_t i = 0; i < spans; ++i)
    sum += ms[i] = rhi::elapsedNs(limits, stamps[i], stamps[i + 1]) * 1e-6;
  if (stampsExceedWall(sum, result.wallMs)) {
    char text[160];
    std::snprintf(text, sizeof text, "its timestamps span %.3g ms, its wall time is %.3g ms", sum,
                  result.wallMs);
    result.stampsBroken = text;
    return;
  }
  if (mode == FrameMode::Plain) {
    result.deviceMs = sum;
    return;
  }
  for (uint32_t i = 0; i < spans; ++i) result.passes[i].ms = ms[i];
  result.stampedMs = sum;
}

}  // namespace sb
