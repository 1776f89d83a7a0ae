#include "suites/harness/timer_trust.h"

#include <algorithm>
#include <cstdio>

#include "reports/stats/stats.h"
#include "suites/harness/samples.h"

namespace sb {
namespace {

constexpr uint32_t kDraws = 12;
constexpr int kRounds = 7;

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

std::vector<TimerFact> tryTimers(Load& load, bool software) {
  std::vector<double> once, twice, covered, deviceShare;
  for (int i = 0; i < kRounds; ++i) {
    once.push_back(rankingMs(load.run(1, kDraws, FrameMode::Plain), software));
    const FrameResult plain = load.run(1, 2 * kDraws, FrameMode::Plain);
    twice.push_back(rankingMs(plain, software));
    if (plain.deviceMs) deviceShare.push_back(*plain.deviceMs / plain.wallMs);
    const FrameResult stamped = load.run(3, kDraws, FrameMode::Stamped);
    double sum = 0;
    for (const PassResult& p : stamped.passes) sum += p.ms.value_or(0);
    covered.push_back(sum / (software ? stamped.wallMs : stamped.stampedMs.value_or(1)));
  }
  std::vector<TimerFact> facts;
  facts.push_back({"source of times",
                   software ? "software: wall time to completion, and CPU time of all threads"
                            : "gpu-timestamp",
                   true, TimerUse::Frame});
  const report::Ratio ratio = report::pairedRatio(twice, once);
  facts.push_back(fact(TimerUse::Frame, "twice the work takes twice the time",
                       "ratio %.2f, expected 1.6..2.4", ratio.value,
                       ratio.value > 1.6 && ratio.value < 2.4));
  // A timer that misses work misses it in every frame: the best frame decides.
  const double share = report::quantile(covered, 1);
  facts.push_back(fact(TimerUse::Passes, "passes sum to the stamped frame",
                       "%.3f of it, expected 0.9..1", share, share >= 0.9 && share <= 1.001));
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
  Load load(context);
  // Pipelines compile at their first draws.
  for (int i = 0; i < 4; ++i) load.run(2, kDraws, FrameMode::Stamped);
  std::vector<TimerFact> facts;
  for (int attempt = 0; attempt < 3; ++attempt) {
    facts = tryTimers(load, software);
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
