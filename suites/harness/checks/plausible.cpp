#include "suites/harness/checks/plausible.h"

#include <fmt/format.h>

namespace sb {
namespace {

struct Rate {
  const char* of;
  double count;      ///< in a frame
  double perSecond;  ///< physical limit
};

uint64_t fragmentsOf(const Samples& samples) {
  uint64_t fragments = 0;
  if (samples.counted)
    for (const PassResult& p : samples.counted->passes) fragments += p.fragments.value_or(0);
  return fragments;
}

}  // namespace

std::string whyImplausible(const Samples& samples, bool software) {
  double run = 0, least = 0, most = 0;
  bool first = true;
  for (const SampleBlock& block : samples.blocks)
    for (const FrameResult& f : block.frames) {
      const double ms = frameMs(f, software);
      run += f.wallMs;
      least = first ? ms : std::min(least, ms);
      most = std::max(most, ms);
      first = false;
    }
  if (!(least > 0)) return "timer not trusted: a frame took no time";
  if (most > run)
    return fmt::format("timer not trusted: a frame took {:.3g} ms, all of them were done in {:.3g}",
                       most, run);
  const rhi::Counters& c = samples.blocks.back().frames.back().counters;
  // A triangle clock gives some 1e10 triangles, raster units some 1e12 fragments, a front end some
  // 1e8 draws a second.
  const Rate rates[] = {{"draws", double(c.draws), 1e10},
                        {"triangles", double(c.triangles), 1e12},
                        {"fragments", double(fragmentsOf(samples)), 1e14}};
  for (const Rate& r : rates)
    if (const double rate = r.count / (least * 1e-3); rate > r.perSecond)
      return fmt::format("timer not trusted: {:.3g} {} in {:.3g} ms are {:.3g} a second, no device "
                         "does more than {:.0g}",
                         r.count, r.of, least, rate, r.perSecond);
  return "";
}

}  // namespace sb
