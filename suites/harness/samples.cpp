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

double sumOfPasses(const FrameResult& frame) {
  double sum = 0;
  for (const PassResult& p : frame.passes) sum += p.ms.value_or(0);
  return sum;
}

double totalOf(std::span<const FrameResult> loop) {
  double total = 0;
  for (const FrameResult& f : loop) total += f.stampedMs.value_or(0);
  return total;
}

/// The loop of stamped frames whose total is the (lower) median: all figures of the breakdown come
/// from one loop (of a standing camera: one frame), so that they add up.
std::span<const FrameResult> medianLoop(const std::vector<FrameResult>& frames, size_t length) {
  std::vector<std::span<const FrameResult>> loops;
  for (size_t i = 0; i + length <= frames.size(); i += length)
    loops.push_back(std::span(frames).subspan(i, length));
  std::ranges::sort(loops, {}, totalOf);
  return loops[(loops.size() - 1) / 2];
}

/// Why the stamps of passes cannot be believed, or "". A timer that misses work misses it in every
/// frame, a neighbour disturbs some: the best frame decides.
std::string whyPassesUntrusted(const std::vector<FrameResult>& frames) {
  double best = 0;
  for (const FrameResult& f : frames) {
    if (sumOfPasses(f) > f.wallMs * 1.001)
      return "timer not trusted: the passes of a frame sum to more than its wall time";
    // 0.2 ms: beginning and submitting a frame, which is nearly all of a tiny one.
    best = std::max(best, (sumOfPasses(f) + 0.2) / std::max(1e-6, f.wallMs));
  }
  if (best >= 0.9) return "";
  return "timer not trusted: the passes sum to " + std::to_string(int(100 * best)) +
         " % of the stamped frame at most, expected 90 %";
}

void summarisePasses(const Samples& samples, bool software, report::Record& record) {
  std::string why = !samples.passesUntrusted.empty() ? samples.passesUntrusted
                    : samples.stamped.empty()        ? "no stamped frame was measured"
                    // On other devices wall time holds the way to the device and back.
                    : software ? whyPassesUntrusted(samples.stamped)
                               : "";
  if (!why.empty()) {
    for (const char* key : {"passes", "shadow_ms", "scene_ms", "combined_ms", "stamped_frame_ms"})
      record.why[key] = why;
    return;
  }
  const std::span<const FrameResult> loop = medianLoop(samples.stamped, samples.loop);
  const double share = 1.0 / double(loop.size());
  const double total = totalOf(loop) * share;
  double shadow = 0, scene = 0;
  const auto passOf = [&](const std::string& label) {
    auto pass = std::ranges::find(record.passes, label, &report::PassRecord::label);
    if (pass == record.passes.end())
      pass = record.passes.insert(pass, {.label = label, .count = 0, .fragments = {}});
    return pass;
  };
  for (const FrameResult& frame : loop)
    for (const PassResult& p : frame.passes) {
      const double ms = p.ms.value_or(0) * share;
      (p.group == PassGroup::Shadow ? shadow : scene) += ms;
      const auto pass = passOf(p.label);
      pass->ms += ms;
      pass->share += total > 0 ? ms / total : 0;
    }
  for (size_t i = 0; i < loop.back().passes.size(); ++i) {
    const PassResult& p = loop.back().passes[i];
    const auto pass = passOf(p.label);
    ++pass->count;
    pass->draws += p.counters.draws;
    pass->triangles += p.counters.triangles;
    if (samples.counted && i < samples.counted->passes.size())
      if (const auto& fragments = samples.counted->passes[i].fragments)
        pass->fragments = pass->fragments.value_or(0) + *fragments;
  }
  record.shadowMs = shadow;
  record.sceneMs = scene;
  record.combinedMs = shadow + scene;
  // Passes lie between consecutive stamps: their sum exceeds the whole by rounding alone.
  record.stampedFrameMs = std::max(total, shadow + scene);
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
  const FrameResult& any = samples.blocks.front().frames.back();
  record.timeSource = software ? "software" : any.deviceMs ? "gpu-timestamp" : "wall";
  auto spread = [&](auto pick) { return report::distribution(collect(samples, pick)); };
  record.frame = spread([&](const FrameResult& f) { return frameMs(f, software); });
  record.wall = spread([](const FrameResult& f) { return f.wallMs; });
  record.cpu = spread([](const FrameResult& f) { return f.cpuMs; });
  record.record = spread([](const FrameResult& f) { return f.recordMs; });
  record.submitMs =
      report::median(collect(samples, [](const FrameResult& f) { return f.submitMs; }));
  record.compileMs = samples.compileMs;
  if (any.deviceMs)
    record.device_ = spread([](const FrameResult& f) { return f.deviceMs.value_or(0); });
  else
    record.why["device_ms"] = "this driver's stamps cost a flush: plain frames carry none";
  if (record.device_ && record.device_->median > record.wall->median * 1.001) {
    record.device_ = {};
    record.why["device_ms"] = "timer not trusted: device time exceeds wall time";
  }
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
