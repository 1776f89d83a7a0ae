#include "suites/truth/bvh.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

#include "suites/truth/watertight.h"

namespace sb {
namespace {

/// One ray's search: tests triangles and keeps what the judge says.
class Search {
 public:
  Search(const std::vector<TruthTriangle>& triangles, const TruthRay& ray, const Bvh::Judge& judge,
         std::vector<TruthHit>& out)
      : m_triangles(triangles),
        m_ray(ray),
        m_sheared(ray.origin, ray.direction),
        m_judge(judge),
        m_out(out) {
    out.clear();
  }

  void test(uint32_t index) {
    if (m_stopped) return;
    const auto hit = intersect(m_sheared, m_triangles[index].corners);
    if (!hit || !(hit->t > m_ray.tMin) || !(hit->t < m_ray.tMax) || hit->t > m_nearest) return;
    const TruthHit found{hit->t, hit->b, hit->c, index, hit->front};
    const Bvh::Verdict verdict = m_judge(found);
    if (verdict == Bvh::Verdict::Ignore) return;
    if (verdict == Bvh::Verdict::Stop) {
      m_stopped = true;
      m_out = {found};
      return;
    }
    if (verdict == Bvh::Verdict::Nearest) m_nearest = std::min(m_nearest, hit->t + m_ray.tie);
    m_out.push_back(found);
  }

  void finish() {
    std::ranges::sort(m_out, {}, [](const TruthHit& h) { return std::tuple(h.t, h.triangle); });
    std::erase_if(m_out, [&](const TruthHit& h) { return h.t > m_nearest; });
  }

  bool stopped() const { return m_stopped; }
  double nearest() const { return m_nearest; }

 private:
  const std::vector<TruthTriangle>& m_triangles;
  const TruthRay& m_ray;
  const ShearedRay<double> m_sheared;
  const Bvh::Judge& m_judge;
  std::vector<TruthHit>& m_out;
  double m_nearest = std::numeric_limits<double>::infinity();
  bool m_stopped = false;
};

struct SearchContext {
  RTCIntersectContext embree;  // first: Embree hands back a pointer to it
  Search* search;
  double length;  ///< of the ray's direction: Embree's has length 1
  double margin;
};

float roundedDown(double v) { return std::nextafter(float(v), -HUGE_VALF); }
float roundedUp(double v) { return std::nextafter(float(v), HUGE_VALF); }

void onIntersect(const RTCIntersectFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const auto& context = *reinterpret_cast<const SearchContext*>(args->context);
  Search& search = *context.search;
  search.test(args->primID);
  auto* ray = reinterpret_cast<RTCRayHit*>(args->rayhit);
  if (search.stopped())
    ray->ray.tfar = -HUGE_VALF;
  else if (std::isfinite(search.nearest()))
    // Boxes that begin behind what ends the ray need not be entered.
    ray->ray.tfar = std::min(
        ray->ray.tfar, roundedUp(search.nearest() * context.length * (1 + 1e-5) + context.margin));
}

[[noreturn]] void fail(RTCDevice device, const char* what) {
  throw std::runtime_error(std::string("Embree: ") + what + ": error " +
                           std::to_string(int(rtcGetDeviceError(device))));
}

}  // namespace

struct Bvh::Impl {
  const std::vector<TruthTriangle>& triangles;
  double margin = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::atomic<int64_t> bytes = 0;

  static bool count(void* self, ssize_t bytes, bool) {
    static_cast<Impl*>(self)->bytes += bytes;
    return true;
  }

  static void bounds(const RTCBoundsFunctionArguments* args) {
    const Impl& impl = *static_cast<const Impl*>(args->geometryUserPtr);
    const auto& corners = impl.triangles[args->primID].corners;
    const glm::dvec3 low = glm::min(glm::min(corners[0], corners[1]), corners[2]) - impl.margin;
    const glm::dvec3 high = glm::max(glm::max(corners[0], corners[1]), corners[2]) + impl.margin;
    RTCBounds& b = *args->bounds_o;
    b.lower_x = roundedDown(low.x);
    b.lower_y = roundedDown(low.y);
    b.lower_z = roundedDown(low.z);
    b.upper_x = roundedUp(high.x);
    b.upper_y = roundedUp(high.y);
    b.upper_z = roundedUp(high.z);
  }

  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

Bvh::Bvh(const std::vector<TruthTriangle>& triangles, double reach)
    : m_impl(new Impl{.triangles = triangles}) {
  double extent = reach;
  for (const TruthTriangle& t : triangles)
    for (const glm::dvec3& p : t.corners)
      extent = std::max(extent, std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
  // Half an ulp of the origin, and of the direction over twice the extent: 2^-22 of the extent; four
  // times that.
  m_impl->margin = extent * 0x1p-20;
  m_impl->device = rtcNewDevice(nullptr);
  if (!m_impl->device) fail(nullptr, "no device");
  rtcSetDeviceMemoryMonitorFunction(m_impl->device, Impl::count, m_impl.get());
  m_impl->scene = rtcNewScene(m_impl->device);
  rtcSetSceneFlags(m_impl->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(m_impl->device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, unsigned(triangles.size()));
  rtcSetGeometryUserData(geometry, m_impl.get());
  rtcSetGeometryBoundsFunction(geometry, Impl::bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, onIntersect);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(m_impl->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(m_impl->scene);
  if (rtcGetDeviceError(m_impl->device) != RTC_ERROR_NONE) fail(m_impl->device, "no tree");
}

Bvh::~Bvh() = default;

uint64_t Bvh::bytes() const { return uint64_t(std::max<int64_t>(0, m_impl->bytes)); }

void Bvh::hits(const TruthRay& ray, const Judge& judge, std::vector<TruthHit>& out) const {
  Search search(m_impl->triangles, ray, judge, out);
  const double length = glm::length(ray.direction);
  SearchContext context{{}, &search, length, 2 * m_impl->margin};
  rtcInitIntersectContext(&context.embree);
  const glm::dvec3 d = ray.direction / length;
  RTCRayHit query{};
  query.ray.org_x = float(ray.origin.x);
  query.ray.org_y = float(ray.origin.y);
  query.ray.org_z = float(ray.origin.z);
  // Unit length, so that distances are those of the scene.
  query.ray.dir_x = float(d.x);
  query.ray.dir_y = float(d.y);
  query.ray.dir_z = float(d.z);
  query.ray.tnear = 0;
  query.ray.tfar = std::isfinite(ray.tMax)
                       ? roundedUp(ray.tMax * length * (1 + 1e-5) + 2 * m_impl->margin)
                       : HUGE_VALF;
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(m_impl->scene, &context.embree, &query);
  search.finish();
}

void Bvh::hitsOfAll(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
                    const Judge& judge, std::vector<TruthHit>& out) {
  Search search(triangles, ray, judge, out);
  for (uint32_t i = 0; i < triangles.size(); ++i) search.test(i);
  search.finish();
}

void Bvh::hitsOf(const std::vector<TruthTriangle>& triangles, std::span<const uint32_t> among,
                 const TruthRay& ray, const Judge& judge, std::vector<TruthHit>& out) {
  Search search(triangles, ray, judge, out);
  for (const uint32_t i : among) search.test(i);
  search.finish();
}

}  // namespace sb
