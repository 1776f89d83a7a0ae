#include "suites/harness/samples.h"

#include <algorithm>

#include "reports/stats/stats.h"

namespace sb {
namespace {

template <class Pick>
std::vector<double> collect(const Samples& samples, const Pick& pick) {
  std::vector<double> values;
  for (const SampleBlock& block : samples.blocks)
    for (const FrameResult& f : block.frames) values.push_back(pick(f));
  return values;
}

/// Medians over stamped frames, pass by pass; passes of a frame come in a fixed order.
void summarisePasses(const Samples& samples, bool software, report::Record& record) {
  if (samples.stamped.empty()) {
    record.why["passes"] = "no stamped frame was measured";
    return;
  }
  const auto& layout = samples.stamped.front().passes;
  auto medianOf = [&](auto pick) {
    std::vector<double> values;
    for (const FrameResult& f : samples.stamped) values.push_back(pick(f));
    return report::median(values);
  };
  const double total =
      medianOf([](const FrameResult& f) { return f.stampedMs.value_or(0); });
  record.stampedFrameMs = total;
  auto groupMs = [&](PassGroup group) {
    return medianOf([&](const FrameResult& f) {
      double sum = 0;
      for (const PassResult& p : f.passes) sum += p.group == group ? p.ms.value_or(0) : 0;
      return sum;
    });
  };
  record.shadowMs = groupMs(PassGroup::Shadow);
  record.sceneMs = groupMs(PassGroup::Scene);
  // Per frame, then the median: never more than the stamped frame it is a part of.
  record.combinedMs = std::min(total, medianOf([](const FrameResult& f) {
                                 double sum = 0;
                                 for (const PassResult& p : f.passes) sum += p.ms.value_or(0);
                                 return sum;
                               }));
  for (size_t i = 0; i < layout.size(); ++i) {
    const double ms = medianOf([&](const FrameResult& f) { return f.passes[i].ms.value_or(0); });
    report::PassRecord pass{.label = layout[i].label,
                            .ms = ms,
                            .share = total > 0 ? ms / total : 0,
                            .draws = layout[i].counters.draws,
                            .triangles = layout[i].counters.triangles};
    if (samples.counted && i < samples.counted->passes.size())
      pass.fragments = samples.counted->passes[i].fragments;
    record.passes.push_back(std::move(pass));
  }
  const double wall = medianOf([](const FrameResult& f) { return f.wallMs; });
  if (software && *record.combinedMs < 0.9 * wall - 0.2)
    record.warnings.push_back("timer not trusted: the passes sum to " +
                              std::to_string(int(100 * *record.combinedMs / wall)) +
                              " % of the stamped frame's wall time");
}

}  // namespace

double rankingMs(const FrameResult& frame, bool software) {
  return software ? frame.cpuMs : frameMs(frame, software);
}

double frameMs(const FrameResult& frame, bool software) {
  return software ? frame.wallMs : frame.deviceMs.value_or(frame.wallMs);
}

std::vector<double> blockMeans(const Samples& samples, bool software) {
  std::vector<double> means;
  for (const SampleBlock& block : samples.blocks) {
    double sum = 0;
    for (const FrameResult& f : block.frames) sum += rankingMs(f, software);
    means.push_back(sum / double(std::max<size_t>(1, block.frames.size())));
  }
  return means;
}

void summarise(const Samples& samples, bool software, report::Record& record) {
  record.timeSource = software ? "software" : "gpu-timestamp";
  auto spread = [&](auto pick) { return report::distribution(collect(samples, pick)); };
  record.frame = spread([&](const FrameResult& f) { return frameMs(f, software); });
  record.wall = spread([](const FrameResult& f) { return f.wallMs; });
  record.cpu = spread([](const FrameResult& f) { return f.cpuMs; });
  record.record = spread([](const FrameResult& f) { return f.recordMs; });
  record.submitMs = report::median(collect(samples, [](const FrameResult& f) { return f.submitMs; }));
  record.compileMs = samples.compileMs;
  const FrameResult& any = samples.blocks.front().frames.front();
  if (any.deviceMs)
    record.device_ = spread([](const FrameResult& f) { return f.deviceMs.value_or(0); });
  else
    record.why["device_ms"] = "this driver's stamps cost a flush: plain frames carry none";
  if (record.device_ && record.device_->median > record.wall->median * 1.001)
    record.warnings.push_back("timer not trusted: device time exceeds wall time");
  for (const SampleBlock& block : samples.blocks) {
    report::Block b{.frames = uint32_t(block.frames.size())};
    for (const FrameResult& f : block.frames) {
      b.frameMs += frameMs(f, software) / double(block.frames.size());
      b.cpuMs += f.cpuMs / double(block.frames.size());
    }
    record.blocks.push_back(b);
  }
  record.passCount = any.counters.passes;
  record.drawCount = any.counters.draws;
  record.triangleCount = any.counters.triangles;
  summarisePasses(samples, software, record);
}

}  // namespace sb
