#include "suites/truth/media/media_march.h"

#include <algorithm>
#include <cmath>

namespace sb {
namespace {

using glm::dvec3;

constexpr uint32_t kSteps = 16;     ///< to begin with
constexpr double kAgree = 0x1p-12;  ///< of the unshadowed light: a step and its halves agree
constexpr int kHalvings = 12;       ///< of a step: shadow edges are found to 1e-5 of the way
constexpr int kMostHalvings = 64;   ///< ... where a step swallows all light
constexpr double kThick = 0.25;     ///< optical depth that one step may cover
constexpr double kDark = 1e-6;      ///< share of light that no longer counts
/// At the ends, where surfaces may stand, lights are asked for this share of the way within.
constexpr double kInset = 1e-6;

double greatest(const dvec3& v) { return std::max({v.x, v.y, v.z}); }

}  // namespace

MediaMarch::MediaMarch(const MediaField::Way& way, const MediaField::Lights& lights)
    : m_way(way), m_lights(lights), m_first(way.stretch.to), m_last(way.stretch.from) {
  for (size_t i = 0; i < way.count; ++i) {
    m_first = std::min(m_first, way.spans[i].from);
    m_last = std::max(m_last, way.spans[i].to);
  }
}

dvec3 MediaMarch::lightOf(const Step& step, Node& node, bool shadowed) {
  dvec3 light(0);
  if (!step.scatters) return light;
  if (!node.asked) {
    const double inset = kInset * (m_last - m_first);
    const double at = node.at <= m_first  ? m_first + inset
                      : node.at >= m_last ? m_last - inset
                                          : node.at;
    m_lights(m_way.stretch.at(at), node.lights);
    node.asked = true;
  }
  for (const MediaField::Arrival& a : node.lights) {
    const double cosine = glm::dot(a.toLight, m_way.stretch.direction);
    dvec3 share(0);
    for (size_t i = 0; i < m_way.count; ++i)
      share += step.scattered[i] *
               gpu::henyeyGreenstein(double(m_way.spans[i].box->medium->anisotropy), cosine);
    light += share * a.irradiance * (shadowed ? a.visible : dvec3(1));
  }
  return light;
}

MediaMarch::Step MediaMarch::step(Node* from, Node* to) {
  Step step{.from = from, .middle = node(0.5 * (from->at + to->at)), .to = to, .scattered = {}};
  for (size_t i = 0; i < m_way.count; ++i) {
    const MediaField::Span& span = m_way.spans[i];
    const double density = MediaField::densityOver(m_way, span, from->at, to->at);
    step.scattered[i] = density * span.box->scattering;
    step.depth += density * span.box->extinction;
    step.scatters |= step.scattered[i] != dvec3(0);
  }
  step.transmittance = glm::exp(-step.depth);
  dvec3 taken(1);  // over the depth
  for (int c = 0; c < 3; ++c)
    if (step.depth[c] > 0) taken[c] = -std::expm1(-step.depth[c]) / step.depth[c];
  for (size_t i = 0; i < m_way.count; ++i) step.scattered[i] *= taken;
  step.light = lightOf(step, *step.middle);
  step.unshadowed = lightOf(step, *step.middle, false);
  return step;
}

std::vector<MediaMarch::Step> MediaMarch::steps(uint32_t count) {
  std::vector<double> ends;
  for (size_t i = 0; i < m_way.count; ++i)
    ends.insert(ends.end(), {m_way.spans[i].from, m_way.spans[i].to});
  std::ranges::sort(ends);
  const auto within = [&](double t) {
    return std::any_of(m_way.spans.begin(), m_way.spans.begin() + m_way.count,
                       [&](const MediaField::Span& s) { return t >= s.from && t < s.to; });
  };
  double length = 0;
  for (size_t i = 0; i + 1 < ends.size(); ++i)
    if (within(ends[i])) length += ends[i + 1] - ends[i];
  std::vector<Step> all;
  for (size_t i = 0; i + 1 < ends.size(); ++i) {
    const double first = ends[i], size = ends[i + 1] - first;
    if (!(size > 0) || !within(first)) continue;
    const double pieces = std::max(1.0, std::round(count * size / length));
    Node* from = node(first);
    for (double k = 1; k <= pieces; ++k) {
      Node* to = node(k < pieces ? first + size * (k / pieces) : ends[i + 1]);
      all.push_back(step(from, to));
      from = to;
    }
  }
  return all;
}

MediaField::Passage MediaMarch::inSteps(uint32_t count) {
  MediaField::Passage out;
  for (const Step& step : steps(count)) {
    out.light += out.transmittance * step.light;
    out.transmittance *= step.transmittance;
  }
  return out;
}

dvec3 MediaMarch::bend(const Step& step) {
  return glm::abs(lightOf(step, *step.from) + lightOf(step, *step.to) - 2.0 * step.light);
}

/// Of a step that is dark at its middle all the same, light may leave near its beginning.
bool MediaMarch::swallows(const Step& step) const {
  for (int c = 0; c < 3; ++c)
    if (step.depth[c] > kThick && m_through[c] > kDark) return true;
  return false;
}

void MediaMarch::add(const Step& whole, double allowed, int halved) {
  if (greatest(m_through) < kDark) return;
  const Step left = step(whole.from, whole.middle), right = step(whole.middle, whole.to);
  const dvec3 halves = left.light + left.transmittance * right.light;
  // Of smooth light an eighth of the bend is as much; an edge near an end shows in the bend alone.
  const dvec3 change = glm::max(glm::abs(halves - whole.light), bend(whole) / 8.0);
  const bool agree = greatest(m_through * change) <= allowed || halved >= kHalvings;
  if ((agree && !swallows(whole)) || halved >= kMostHalvings) {
    m_light += m_through * glm::max(dvec3(0), halves + (halves - whole.light) / 3.0);
    m_through *= left.transmittance * right.transmittance;
    return;
  }
  add(left, allowed, halved + 1);
  add(right, allowed, halved + 1);
}

dvec3 MediaMarch::light() {
  const std::vector<Step> coarse = steps(kSteps);
  dvec3 unshadowed(0), through(1);
  for (const Step& step : coarse) {
    unshadowed += through * step.unshadowed;
    through *= step.transmittance;
  }
  if (unshadowed == dvec3(0)) return dvec3(0);
  for (const Step& step : coarse) add(step, kAgree * greatest(unshadowed), 0);
  return m_light;
}

}  // namespace sb
