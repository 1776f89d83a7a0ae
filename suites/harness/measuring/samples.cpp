#include "suites/harness/measuring/samples.h"

#include <algorithm>

#include "reports/stats/stats.h"

namespace sb {
namespace {

template <class Pick>
std::vector<double> meansOf(const Samples& samples, const Pick& pick) {
  std::vector<double> means;
  for (const SampleBlock& block : samples.blocks) {
    double sum = 0;
    for (const FrameResult& f : block.frames) sum += pick(f);
    means.push_back(sum / double(std::max<size_t>(1, block.frames.size())));
  }
  return means;
}

template <class Pick>
std::vector<double> collect(const Samples& samples, const Pick& pick) {
  std::vector<double> values;
  for (const SampleBlock& block : samples.blocks)
    for (const FrameResult& f : block.frames) values.push_back(pick(f));
  return values;
}

std::string whyNoDeviceTime(const Samples& samples, bool software) {
  for (const SampleBlock& block : samples.blocks)
    for (const FrameResult& f : block.frames)
      if (!f.stampsBroken.empty()) return "timer not trusted: " + f.stampsBroken;
  return software ? "this driver's stamps cost a flush: plain frames carry none"
                  : "the device has no timestamps";
}

double sumOfPasses(const FrameResult& frame) {
  double sum = 0;
  for (const PassResult& p : frame.passes) sum += p.ms.value_or(0);
  return sum;
}

double totalOf(const StampedLoop& loop) {
  double total = 0;
  for (const FrameResult& f : loop.stamped) total += f.stampedMs.value_or(0);
  return total;
}

/// The loop of stamped frames whose total is the (lower) median: all figures of the breakdown come
/// from one loop (of a standing camera: one frame), so that they add up.
const StampedLoop& medianLoop(const std::vector<StampedLoop>& loops) {
  std::vector<const StampedLoop*> sorted;
  for (const StampedLoop& loop : loops) sorted.push_back(&loop);
  std::ranges::sort(sorted, {}, [](const StampedLoop* loop) { return totalOf(*loop); });
  return *sorted[(sorted.size() - 1) / 2];
}

/// Why the stamps of passes cannot be believed, or "". The passes of a frame sum to at most its
/// wall time, and to at least nine tenths of what the same frame takes without stamps between
/// passes: work that the stamps miss is missing there. A timer that misses work misses it in every
/// frame, a neighbour disturbs some: the best frame decides.
std::string whyPassesUntrusted(const std::vector<StampedLoop>& loops, bool software) {
  // Software frames are wall time, of which beginning and submitting are nearly all where a frame
  // is tiny.
  const double slack = software ? 0.2 : 0.005;
  double best = 0;
  for (const StampedLoop& loop : loops)
    for (size_t i = 0; i < loop.stamped.size(); ++i) {
      const FrameResult& stamped = loop.stamped[i];
      const double sum = sumOfPasses(stamped);
      if (sum > stamped.wallMs * 1.001)
        return "timer not trusted: the passes of a frame sum to more than its wall time";
      const double whole = software ? stamped.wallMs : frameMs(loop.plain[i], software);
      best = std::max(best, (sum + slack) / std::max(1e-6, whole));
    }
  if (best >= 0.9) return "";
  return "timer not trusted: the passes sum to " + std::to_string(int(100 * best)) + " % of the " +
         (software ? "stamped frame" : "frame without stamps between passes") +
         " at most, expected 90 %";
}

void summarisePasses(const Samples& samples, bool software, report::Record& record) {
  const std::string why = !samples.passesUntrusted.empty() ? samples.passesUntrusted
                          : samples.stamped.empty()        ? "no stamped frame could be believed"
                          : !samples.stamped.front().stamped.front().stampedMs
                              ? "the device has no timestamps"
                              : whyPassesUntrusted(samples.stamped, software);
  if (!why.empty()) {
    for (const char* key : {"passes", "shadow_ms", "scene_ms", "combined_ms", "stamped_frame_ms"})
      record.why[key] = why;
    return;
  }
  const StampedLoop& middle = medianLoop(samples.stamped);
  const std::vector<FrameResult>& loop = middle.stamped;
  const double share = 1.0 / double(loop.size());
  const double total = totalOf(middle) * share;
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
      pass->recordMs += p.recordMs * share;
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

bool addBlock(Samples& samples, std::vector<FrameResult> frames, bool software) {
  SampleBlock block;
  for (size_t i = 0; i + samples.loop <= frames.size(); i += samples.loop) {
    const auto loop = std::span(frames).subspan(i, samples.loop);
    if (software || std::ranges::all_of(loop, &std::string::empty, &FrameResult::stampsBroken))
      block.frames.insert(block.frames.end(), loop.begin(), loop.end());
    else
      samples.dropped += loop.size();
  }
  if (block.frames.empty()) return false;
  samples.blocks.push_back(std::move(block));
  return true;
}

void addStamped(Samples& samples, StampedLoop loop) {
  for (const auto* frames : {&loop.stamped, &loop.plain})
    for (const FrameResult& f : *frames)
      if (!f.stampsBroken.empty()) return;
  samples.stamped.push_back(std::move(loop));
}

std::vector<double> blockMeans(const Samples& samples, bool software) {
  return meansOf(samples, [&](const FrameResult& f) { return rankingMs(f, software); });
}

void summarise(const Samples& samples, bool software, report::Record& record) {
  const FrameResult& any = samples.blocks.front().frames.back();
  record.timeSource = software ? "software" : any.deviceMs ? "gpu-timestamp" : "wall";
  auto spread = [&](auto pick) {
    report::Distribution d = report::distribution(collect(samples, pick));
    d.median = report::median(meansOf(samples, pick));
    return d;
  };
  record.frame = spread([&](const FrameResult& f) { return frameMs(f, software); });
  record.wall = spread([](const FrameResult& f) { return f.wallMs; });
  record.cpu = spread([](const FrameResult& f) { return f.cpuMs; });
  record.record = spread([](const FrameResult& f) { return f.recordMs; });
  record.submitMs =
      report::median(collect(samples, [](const FrameResult& f) { return f.submitMs; }));
  record.compileMs = samples.compileMs;
  record.droppedFrames = samples.dropped;
  if (samples.dropped > 0)
    record.warnings.push_back(std::to_string(samples.dropped) +
                              " frames were dropped: their time stamps exceed their wall time, as "
                              "after a reset of the device's counter");
  const auto deviceMs = collect(samples, [](const FrameResult& f) { return f.deviceMs.has_value(); });
  if (std::ranges::all_of(deviceMs, [](double has) { return has > 0; }))
    record.device_ = spread([](const FrameResult& f) { return *f.deviceMs; });
  else
    record.why["device_ms"] = whyNoDeviceTime(samples, software);
  const std::vector<double> frameMeans =
      meansOf(samples, [&](const FrameResult& f) { return frameMs(f, software); });
  const std::vector<double> cpuMeans =
      meansOf(samples, [](const FrameResult& f) { return f.cpuMs; });
  for (size_t i = 0; i < samples.blocks.size(); ++i)
    record.blocks.push_back({.frames = uint32_t(samples.blocks[i].frames.size()),
                             .frameMs = frameMeans[i],
                             .cpuMs = cpuMeans[i]});
  record.passCount = any.counters.passes;
  record.drawCount = any.counters.draws;
  record.triangleCount = any.counters.triangles;
  summarisePasses(samples, software, record);
}

}  // namespace sb
