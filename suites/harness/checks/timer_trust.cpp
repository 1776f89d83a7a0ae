#include "suites/harness/checks/timer_trust.h"

#include <algorithm>
#include <cstdio>

#include "reports/stats/stats.h"
#include "suites/harness/measuring/samples.h"

namespace sb {
namespace {

constexpr uint32_t kDraws = 12;
constexpr int kRounds = 7;
constexpr double kLongMs = 20;        ///< of wall time: what is around the work is little of it
constexpr uint32_t kMostDraws = 1 << 16;

class Load {
 public:
  explicit Load(const DeviceContext& context)
      : m_context(context), m_runner(context.device, context.queries) {
    m_target = context.device.createTexture({.label = "timer load",
                                             .format = rhi::Format::RGBA16Float,
                                             .width = 256,
                                             .height = 256,
                                             .use = rhi::TextureUse::ColorTarget});
    m_pipeline =
        context.pipelines.get({.label = "timer load",
                               .vertex = &context.shaders.get("common/fullscreen.vert"),
                               .fragment = &context.shaders.get("common/timer_load.frag"),
                               .targets = {{.format = rhi::Format::RGBA16Float,
                                            .blend = {.enabled = true,
                                                      .dstColor = rhi::BlendFactor::One,
                                                      .dstAlpha = rhi::BlendFactor::One}}}});
  }

  /// `passes` passes of `draws` blended full-screen triangles each.
  FrameResult run(uint32_t passes, uint32_t draws, FrameMode mode) {
    return m_runner.run(mode, [&](Frame& frame) {
      for (uint32_t p = 0; p < passes; ++p) {
        const rhi::ColorAttachment color{.view = {.texture = m_target},
                                         .load = p == 0 ? rhi::LoadOp::Clear : rhi::LoadOp::Load};
        frame.pass({.label = "load", .colors = std::span(&color, 1)}, PassGroup::Scene,
                   [&](rhi::CommandList& commands) {
                     for (uint32_t i = 0; i < draws; ++i)
                       commands.draw({.pipeline = m_pipeline}, {.vertexCount = 3});
                   });
      }
    });
  }

 private:
  const DeviceContext& m_context;
  FrameRunner m_runner;
  rhi::Texture m_target;
  rhi::PipelineId m_pipeline;
};

TimerFact fact(TimerUse use, const char* name, const char* format, double value, bool trusted) {
  char text[160];
  std::snprintf(text, sizeof text, format, value);
  return {name, text, trusted, use};
}

/// Device time over wall time of a frame that is long enough to be mostly work.
double shareOfLongFrame(Load& load) {
  for (uint32_t draws = kDraws;; draws *= 2) {
    const FrameResult frame = load.run(1, draws, FrameMode::Plain);
    if (frame.wallMs >= kLongMs || draws >= kMostDraws)
      return frame.deviceMs.value_or(0) / frame.wallMs;
  }
}

const char* sourceOf(bool software, bool stamps) {
  if (software) return "software: wall time to completion, and CPU time of all threads";
  return stamps ? "gpu-timestamp" : "wall: the device has no timestamps";
}

std::vector<TimerFact> tryTimers(Load& load, bool software, bool stamps) {
  std::vector<double> once, twice, covered, deviceShare;
  for (int i = 0; i < kRounds; ++i) {
    once.push_back(rankingMs(load.run(1, kDraws, FrameMode::Plain), software));
    const FrameResult plain = load.run(1, 2 * kDraws, FrameMode::Plain);
    twice.push_back(rankingMs(plain, software));
    if (plain.deviceMs) deviceShare.push_back(*plain.deviceMs / plain.wallMs);
    if (!stamps) continue;
    const FrameResult stamped = load.run(3, kDraws, FrameMode::Stamped);
    double sum = 0;
    for (const PassResult& p : stamped.passes) sum += p.ms.value_or(0);
    const FrameResult whole = load.run(3, kDraws, FrameMode::Plain);
    covered.push_back(sum / (software ? stamped.wallMs : frameMs(whole, software)));
  }
  std::vector<TimerFact> facts;
  facts.push_back({"source of times",
                   sourceOf(software, stamps), true, TimerUse::Frame});
  const report::Ratio ratio = report::pairedRatio(twice, once);
  facts.push_back(fact(TimerUse::Frame, "twice the work takes twice the time",
                       "ratio %.2f, expected 1.6..2.4", ratio.value,
                       ratio.value > 1.6 && ratio.value < 2.4));
  if (!stamps) return facts;
  // A timer that misses work misses it in every frame: the best frame decides. Of software, the
  // stamped frame's wall time is the whole. Elsewhere it is the frame without stamps between its
  // passes, which may take less, since such stamps keep passes from overlapping.
  const double share = report::quantile(covered, 1);
  if (software)
    facts.push_back(fact(TimerUse::Passes, "passes sum to the stamped frame",
                         "%.3f of it, expected 0.9..1", share, share >= 0.9 && share <= 1.001));
  else
    facts.push_back(fact(TimerUse::Passes, "passes sum to the frame without stamps between them",
                         "%.3f of it, expected 0.9..3", share, share >= 0.9 && share <= 3));
  if (!software) {
    const double covers = shareOfLongFrame(load);
    facts.push_back(fact(TimerUse::Frame, "device time is most of a long frame's wall time",
                         "%.3f of it, expected 0.5..1", covers, covers >= 0.5 && covers <= 1.001));
  }
  if (!deviceShare.empty()) {
    const double device = report::median(deviceShare);
    facts.push_back(fact(software ? TimerUse::Passes : TimerUse::Frame,
                         "device time is within wall time", "%.3f of it, expected at most 1",
                         device, device <= 1.001));
  }
  return facts;
}

}  // namespace

std::vector<TimerFact> checkTimers(const DeviceContext& context) {
  const bool software = context.device.isSoftware();
  const bool stamps = context.device.info().limits.timestampBits > 0;
  Load load(context);
  // Pipelines compile at their first draws.
  for (int i = 0; i < 4; ++i) load.run(2, kDraws, FrameMode::Stamped);
  std::vector<TimerFact> facts;
  for (int attempt = 0; attempt < 3; ++attempt) {
    facts = tryTimers(load, software, stamps);
    if (std::ranges::all_of(facts, &TimerFact::trusted)) break;
  }
  return facts;
}

std::string whyUntrusted(const std::vector<TimerFact>& facts, TimerUse use) {
  for (const TimerFact& f : facts)
    if (!f.trusted && f.use == use) return "timer not trusted: " + f.name + ": " + f.finding;
  return "";
}

}  // namespace sb
