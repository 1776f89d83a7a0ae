// What arrives of a light: RayScene::passed, alone and in packets.
#include <limits>

#include "suites/truth/rays/ray_packet.h"
#include "suites/truth/rays/ray_scene.h"

namespace sb {

using glm::dvec3;

namespace {

dvec3 transmittance(const gpu::OpticsData& o) { return 1.0 - double(o.alpha) * (1.0 - dvec3(o.t)); }

}  // namespace

TruthRay RayScene::shadowRay(const Tracer::Point& point, const Target& target, bool stopsUnasked) {
  return {.origin = point.position,
          .direction = target.toward,
          .tMax = target.infinite ? std::numeric_limits<double>::infinity() : 1,
          .own = point.triangle,
          .stopsUnasked = stopsUnasked};
}

Bvh::Verdict RayScene::judgeForLight(const Tracer::Point& point, const Target& target,
                                     double ownNear, const TruthHit& hit) const {
  if (isOwn(hit.triangle, point) ||
      (ownNear > 0 && hit.t < ownNear / glm::length(target.toward) &&
       m_triangles[hit.triangle].instance == point.instance) ||
      (!target.infinite && hit.t > 0.5 && isInPlane(hit.triangle, target.place)))
    return Bvh::Verdict::Ignore;
  const SurfaceTraits& traits = this->traits(hit.triangle);
  const bool perforated = traits.material.lightClass == MaterialClass::Perforated;
  if (traits.blocks || (perforated && surface(hit).optics().alpha >= 0.5f))
    return Bvh::Verdict::Stop;
  return perforated ? Bvh::Verdict::Ignore : Bvh::Verdict::Keep;
}

dvec3 RayScene::passedThrough(const Tracer::Point& point, const Target& target,
                              std::span<const TruthHit> hits) const {
  dvec3 passed(1);
  for (const TruthHit& hit : hits) passed *= transmittance(surface(hit).optics());
  if (m_media.empty()) return passed;
  const TruthRay ray = shadowRay(point, target, false);
  const double length = glm::length(ray.direction);
  return passed *
         m_media.transmittance({ray.origin, ray.direction / length, 0, ray.tMax * length});
}

dvec3 RayScene::passed(const Tracer::Point& point, const Target& target,
                       std::vector<TruthHit>& scratch, double ownNear) const {
  bool stopped = false;
  m_bvh->hits(
      shadowRay(point, target, false),
      [&](const TruthHit& hit) {
        const Bvh::Verdict verdict = judgeForLight(point, target, ownNear, hit);
        stopped |= verdict == Bvh::Verdict::Stop;
        return verdict;
      },
      scratch);
  return stopped ? dvec3(0) : passedThrough(point, target, scratch);
}

class RayScene::ShadowRays {
 public:
  ShadowRays(const RayScene& scene, std::span<ShadowRay> rays) : m_scene(scene), m_rays(rays) {}
  TruthRay ray(size_t i) const {
    // What may be the receiver's own is to be judged.
    return shadowRay(*m_rays[i].point, m_rays[i].target, m_rays[i].ownNear == 0);
  }
  Bvh::Verdict judge(size_t i, const TruthHit& hit) const {
    return m_scene.judgeForLight(*m_rays[i].point, m_rays[i].target, m_rays[i].ownNear, hit);
  }
  void end(size_t i, bool stopped, const std::vector<TruthHit>& hits) {
    ShadowRay& ray = m_rays[i];
    ray.passed = stopped ? dvec3(0) : m_scene.passedThrough(*ray.point, ray.target, hits);
  }

 private:
  const RayScene& m_scene;
  std::span<ShadowRay> m_rays;
};

void RayScene::pass(std::span<ShadowRay> rays, Bvh::PacketHits& scratch) const {
  ShadowRays shadows(*this, rays);
  m_bvh->hits(rays.size(), shadows, scratch);
}

}  // namespace sb
