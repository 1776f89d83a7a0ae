#include "suites/truth/tracer.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <chrono>

#include "suites/truth/lights/sampler.h"
#include "suites/truth/rays/ray_scene.h"

namespace sb {

using glm::dvec3;

struct Tracer::Impl {
  Impl(const Scene& scene, uint32_t width, uint32_t height, unsigned threads)
      : rays(scene, width, height),
        lights(rays),
        arena(threads == 0 ? tbb::task_arena::automatic : int(threads)) {}

  RayScene rays;
  LightVisibility lights;
  mutable tbb::task_arena arena;
  double buildSeconds = 0;
};

Tracer::Tracer(const Scene& scene, uint32_t width, uint32_t height, unsigned threads) {
  const auto start = std::chrono::steady_clock::now();
  m_impl = std::make_unique<Impl>(scene, width, height, threads);
  m_impl->buildSeconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Tracer::~Tracer() = default;

std::optional<Truth> Tracer::trace(const TruthSettings& settings) const {
  std::optional<Truth> truth;
  m_impl->arena.execute([&] { truth = traceTruth(m_impl->rays, m_impl->lights, settings); });
  if (truth) truth->seconds += m_impl->buildSeconds;
  return truth;
}

std::vector<float> Tracer::image(uint32_t raysPerLight, uint64_t* rays) const {
  const RayScene& scene = m_impl->rays;
  std::vector<float> image(size_t(scene.width()) * scene.height() * 4);
  std::atomic<uint64_t> count = 0;
  m_impl->arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<uint32_t>(0, scene.height()), [&](const auto& range) {
      Sampler sampler(scene, m_impl->lights);
      for (uint32_t y = range.begin(); y < range.end(); ++y)
        for (uint32_t x = 0; x < scene.width(); ++x) {
          sampler.find(x + 0.5, y + 0.5, {.pattern = raysPerLight});
          const glm::vec3 color = sampler.color();
          float* out = image.data() + 4 * (size_t(y) * scene.width() + x);
          for (int c = 0; c < 3; ++c) out[c] = color[c];
          out[3] = 1;
        }
      count += sampler.rays();
    });
  });
  if (rays) *rays = count;
  return image;
}

uint64_t Tracer::bytes() const { return m_impl->rays.bytes() + m_impl->lights.bytes(); }

std::optional<Tracer::Point> Tracer::pointAt(uint32_t x, uint32_t y, uint32_t layer) const {
  RayScene::CameraHits found;
  m_impl->rays.cameraHits(x + 0.5, y + 0.5, found);
  if (layer == 0 && !found.endsOpaque) return {};
  const size_t index = layer == 0 ? found.hits.size() - 1 : layer - 1;
  if (index >= found.hits.size()) return {};
  return m_impl->rays.point(x + 0.5, y + 0.5, found.hits[index]);
}

dvec3 Tracer::visibility(uint32_t light, const Point& point, const AreaSampling& sampling) const {
  LightVisibility::Scratch scratch;
  return m_impl->lights.ask(light, point, sampling, scratch).visible;
}

namespace {

/// The plane of a light's map at a point: its axes, and how far the point is along the third.
struct MapFrame {
  glm::dmat3 axes;  ///< rows
  dvec3 relative;   ///< to the light (directional: to the eye), in map axes
  uint32_t face = 0;
  double distance = 1;  ///< axial, local lights
};

MapFrame mapFrame(const RayScene& rays, uint32_t light, const dvec3& position) {
  const Light& l = rays.scene().lights[light];
  MapFrame frame;
  dvec3 from = position;
  if (l.type == LightType::Directional) {
    frame.axes = lightAxes(l.direction);
  } else {
    from -= rays.lightPosition(light);
    frame.face = l.type == LightType::Point ? cubeFaceOf(from) : 0;
    frame.axes = lightAxes(l.type == LightType::Point ? cubeFaceDirection(frame.face) : l.direction);
  }
  frame.relative = frame.axes * from;
  if (l.type != LightType::Directional) frame.distance = -frame.relative.z;
  return frame;
}

/// How well visibility is known where only its range counts.
constexpr AreaSampling kNear = {.first = 64, .most = 64};

/// World half width of a lookup at a point.
double halfWidth(const MapFrame& frame, const LookupReach& reach) {
  return reach.constant + reach.perDistance * frame.distance;
}

}  // namespace

dvec3 Tracer::mapCoordinates(uint32_t light, const Point& point, const LookupReach& reach) const {
  const MapFrame frame = mapFrame(m_impl->rays, light, point.position);
  const double width = reach.constant > 0 ? reach.constant : reach.perDistance * frame.distance;
  return {frame.relative.x / width, frame.relative.y / width, double(frame.face)};
}

Tracer::Range Tracer::visibilityNear(uint32_t light, const Point& point,
                                     const LookupReach& reach) const {
  const RayScene& rays = m_impl->rays;
  LightVisibility::Scratch scratch;
  const auto visibility = [&](const Point& at, double ownNear) {
    return m_impl->lights.ask(light, at, kNear, scratch, ownNear).visible;
  };
  const dvec3 centre = visibility(point, 0);
  Range range{centre, centre};
  const MapFrame frame = mapFrame(rays, light, point.position);
  const double width = halfWidth(frame, reach);
  const dvec3 toLight = rays.toLight(light, point.position);
  const double cosine = glm::dot(point.normal, toLight);
  // Grazing planes run out of the scene: lookups clamp their slope there too.
  const double steepest = 10;
  auto ask = [&](double dx, double dy) {
    const dvec3 offset = glm::transpose(frame.axes) * dvec3(dx * width, dy * width, 0);
    const double along = cosine != 0 ? -glm::dot(point.normal, offset) / cosine : 0;
    const double most = steepest * glm::length(offset);
    Point at = point;
    at.position += offset + toLight * std::min(std::max(along, -most), most);
    // Where the receiver's own surface bends away from its plane lies no shadow's edge: what is
    // dark in the plane alone, and lit on the surface, is not dark.
    const dvec3 plane = visibility(at, 4 * width);
    range.high = glm::max(range.high, plane);
    dvec3 low = plane;
    if (glm::any(glm::lessThan(plane, range.low)))
      if (auto on = rays.ownSurfaceAlong(light, at, 4 * width + std::abs(along), scratch.hits))
        low = glm::max(low, visibility(*on, 4 * width));
    range.low = glm::min(range.low, low);
  };
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x)
      if (x != 0 || y != 0) ask(x / 2.0, y / 2.0);
  return range;
}

}  // namespace sb
