// What arrives of lights at many points: RayScene::pass.
#pragma once

#include "suites/truth/rays/ray_packet.h"
#include "suites/truth/rays/ray_scene.h"

namespace sb {

/// As Bvh::hits asks for them.
template <class Rays>
class RayScene::ShadowRays {
 public:
  ShadowRays(const RayScene& scene, Rays& rays) : m_scene(scene), m_rays(rays) {}

  TruthRay ray(size_t i) const {
    // What may be the receiver's own is to be judged.
    return shadowRay(m_rays.point(i), m_rays.target(i), m_rays.ownNear() == 0);
  }
  Bvh::Verdict judge(size_t i, const TruthHit& hit) const {
    return m_scene.judgeForLight(m_rays.point(i), m_rays.target(i), m_rays.ownNear(), hit);
  }
  void end(size_t i, bool stopped, const std::vector<TruthHit>& hits) {
    if (stopped)
      m_rays.end(i, glm::dvec3(0));
    else if (hits.empty() && m_scene.m_media.empty())
      m_rays.end(i, glm::dvec3(1));
    else
      m_rays.end(i, m_scene.passedThrough(m_rays.point(i), m_rays.target(i), hits));
  }

 private:
  const RayScene& m_scene;
  Rays& m_rays;
};

template <class Rays>
void RayScene::pass(size_t count, Rays& rays, Bvh::PacketHits& scratch) const {
  ShadowRays<Rays> shadows(*this, rays);
  m_bvh->hits(count, shadows, scratch);
}

}  // namespace sb
