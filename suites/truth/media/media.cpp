#include "suites/truth/media/media.h"

#include <algorithm>
#include <cmath>

#include "suites/truth/media/density_integral.h"
#include "suites/truth/media/media_march.h"

namespace sb {
namespace {

using glm::dvec3;

/// Of what is taken out of light, where it is not exact.
constexpr double kDepthError = 1e-5;

/// Where a ray in the unit cube's coordinates is inside [0,1)^3, cut to [from, to].
std::optional<MediaField::Interval> inUnitCube(const dvec3& origin, const dvec3& direction,
                                               double from, double to) {
  for (int axis = 0; axis < 3; ++axis) {
    const double o = origin[axis], d = direction[axis];
    if (d == 0) {
      if (!(o >= 0 && o < 1)) return {};
      continue;
    }
    const double a = -o / d, b = (1 - o) / d;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (!(from < to)) return {};
  return MediaField::Interval{from, to};
}

/// Ends of a stretch and the places between where `origin + t direction` crosses whole numbers.
std::vector<double> planesBetween(const dvec3& origin, const dvec3& direction, double from,
                                  double to) {
  std::vector<double> ends = {from, to};
  for (int axis = 0; axis < 3; ++axis) {
    const double o = origin[axis], d = direction[axis];
    if (d == 0) continue;
    const double a = o + from * d, b = o + to * d;
    for (double k = std::ceil(std::min(a, b)); k <= std::max(a, b); ++k)
      if (const double t = (k - o) / d; t > from && t < to) ends.push_back(t);
  }
  std::ranges::sort(ends);
  return ends;
}

}  // namespace

MediaField::MediaField(const Scene& scene, const dvec3& eye) {
  for (const Medium& medium : scene.media) {
    if (!(greatestDepth(medium) > 0)) continue;
    const dvec3 extinction(medium.extinction);
    m_boxes.push_back({.medium = &medium,
                       .toBox = toBox(medium, eye),
                       .extinction = extinction,
                       .scattering = extinction * dvec3(medium.albedo),
                       .smoke = smokeShape(medium)});
  }
}

MediaField::Way MediaField::wayOf(const Stretch& stretch) const {
  Way way{.stretch = stretch, .spans = {}};
  for (const Box& box : m_boxes) {
    const dvec3 origin(box.toBox * glm::dvec4(stretch.origin, 1));
    const dvec3 direction = glm::dmat3(box.toBox) * stretch.direction;
    if (const auto inside = inUnitCube(origin, direction, stretch.from, stretch.to))
      way.spans[way.count++] = {&box, inside->from, inside->to};
  }
  return way;
}

double MediaField::densityOver(const Way& way, const Span& span, double from, double to) {
  from = std::max(from, span.from), to = std::min(to, span.to);
  if (!(from < to)) return 0;
  const Medium& medium = *span.box->medium;
  if (medium.kind == MediumKind::Homogeneous) return to - from;
  const dvec3 origin(span.box->toBox * glm::dvec4(way.stretch.origin, 1));
  const dvec3 direction = glm::dmat3(span.box->toBox) * way.stretch.direction;
  if (medium.kind == MediumKind::Grid) {
    const dvec3 size(medium.size);
    return cubicPieces([&](double t) { return gridDensity(medium, origin + t * direction); },
                       planesBetween(size * origin - 0.5, size * direction, from, to));
  }
  // Pieces as long as the cells of the noise's first octave.
  const dvec3 cells(8, 6, 8);
  const dvec3& k = span.box->extinction;
  const double densest = std::max({k.x, k.y, k.z});
  return adaptiveSimpson(
      [&](double t) { return gpu::smokeDensity(span.box->smoke, origin + t * direction); },
      planesBetween(cells * origin, cells * direction, from, to), kDepthError / densest, densest);
}

dvec3 MediaField::opticalDepth(const Way& way) {
  dvec3 depth(0);
  for (size_t i = 0; i < way.count; ++i) {
    const Span& span = way.spans[i];
    depth += span.box->extinction * densityOver(way, span, span.from, span.to);
  }
  return depth;
}

dvec3 MediaField::transmittance(const Stretch& stretch) const {
  return glm::exp(-opticalDepth(wayOf(stretch)));
}

std::optional<MediaField::Interval> MediaField::firstInterval(const Stretch& stretch) const {
  Way way = wayOf(stretch);
  if (way.count == 0) return {};
  const auto spans = std::ranges::subrange(way.spans.begin(), way.spans.begin() + way.count);
  std::ranges::sort(spans, {}, &Span::from);
  Interval first{way.spans[0].from, way.spans[0].to};
  for (const Span& span : spans)
    if (span.from <= first.to) first.to = std::max(first.to, span.to);
  return first;
}

MediaField::Passage MediaField::march(const Stretch& stretch, const Lights& lights,
                                      uint32_t steps) const {
  return MediaMarch(wayOf(stretch), lights).inSteps(steps);
}

MediaField::Passage MediaField::pass(const Stretch& stretch, const Lights& lights) const {
  const Way way = wayOf(stretch);
  return {.light = MediaMarch(way, lights).light(), .transmittance = glm::exp(-opticalDepth(way))};
}

}  // namespace sb
