// What arrives of a light: RayScene::passed, alone and in packets.
#include <limits>

#include "suites/truth/rays/ray_scene.h"

namespace sb {

using glm::dvec3;

namespace {

dvec3 transmittance(const gpu::OpticsData& o) { return 1.0 - double(o.alpha) * (1.0 - dvec3(o.t)); }

}  // namespace

/// One shadow ray on its way.
class RayScene::Shadow {
 public:
  void begin(const RayScene& scene, const Tracer::Point& point, const Target& target,
             double ownNear) {
    m_scene = &scene;
    m_point = &point;
    m_target = &target;
    m_own = ownNear > 0 ? ownNear / glm::length(target.toward) : 0;
    m_blocked = false;
    m_ray.origin = point.position;
    m_ray.direction = target.toward;
    m_ray.tMax = target.infinite ? std::numeric_limits<double>::infinity() : 1;
    m_ray.own = point.triangle;
  }
  const TruthRay& ray() const { return m_ray; }
  Bvh::Verdict judge(const TruthHit& hit) {
    if (m_scene->isOwn(hit.triangle, *m_point) ||
        (hit.t < m_own && m_scene->m_triangles[hit.triangle].instance == m_point->instance) ||
        (!m_target->infinite && hit.t > 0.5 && m_scene->isInPlane(hit.triangle, m_target->place)))
      return Bvh::Verdict::Ignore;
    const SurfaceTraits& traits = m_scene->traits(hit.triangle);
    const bool perforated = traits.material.lightClass == MaterialClass::Perforated;
    m_blocked = traits.blocks || (perforated && m_scene->surface(hit).optics().alpha >= 0.5f);
    if (m_blocked) return Bvh::Verdict::Stop;
    return perforated ? Bvh::Verdict::Ignore : Bvh::Verdict::Keep;
  }
  dvec3 passed(const std::vector<TruthHit>& hits) const {
    if (m_blocked) return dvec3(0);
    dvec3 passed(1);
    for (const TruthHit& hit : hits) passed *= transmittance(m_scene->surface(hit).optics());
    if (m_scene->m_media.empty()) return passed;
    const double length = glm::length(m_ray.direction);
    return passed * m_scene->m_media.transmittance(
                        {m_ray.origin, m_ray.direction / length, 0, m_ray.tMax * length});
  }

 private:
  const RayScene* m_scene;
  const Tracer::Point* m_point;
  const Target* m_target;
  TruthRay m_ray;
  double m_own;
  bool m_blocked;
};

dvec3 RayScene::passed(const Tracer::Point& point, const Target& target,
                       std::vector<TruthHit>& scratch, double ownNear) const {
  Shadow shadow;
  shadow.begin(*this, point, target, ownNear);
  m_bvh->hits(
      shadow.ray(), [&](const TruthHit& hit) { return shadow.judge(hit); }, scratch);
  return shadow.passed(scratch);
}

void RayScene::pass(std::span<ShadowRay> rays, PacketHits& scratch) const {
  std::array<Shadow, kPacket> shadows;
  std::array<const TruthRay*, kPacket> traced;
  for (size_t i = 0; i < rays.size(); ++i) {
    shadows[i].begin(*this, *rays[i].point, rays[i].target, rays[i].ownNear);
    traced[i] = &shadows[i].ray();
  }
  m_bvh->hits(
      std::span(traced).first(rays.size()),
      [&](size_t ray, const TruthHit& hit) { return shadows[ray].judge(hit); },
      std::span(scratch).first(rays.size()));
  for (size_t i = 0; i < rays.size(); ++i) rays[i].passed = shadows[i].passed(scratch[i]);
}

}  // namespace sb
