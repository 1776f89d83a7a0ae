// What arrives of a light: RayScene::passed.
#include "suites/truth/rays/ray_scene.h"

namespace sb {

using glm::dvec3;

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
  for (const TruthHit& hit : hits) passed *= transmittance(hit);
  if (m_media.empty()) return passed;
  const TruthRay ray = shadowRay(point, target, false);
  const double length = glm::length(ray.direction);
  return passed * m_media.transmittance({ray.origin, ray.direction / length, 0, ray.tMax * length});
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

}  // namespace sb
