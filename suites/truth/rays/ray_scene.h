// A scene as rays meet it: what a camera ray passes and where it ends, and how much of a light
// arrives at a point (spec 16, camera path and transmittance along a shadow ray). Surfaces in one
// plane (techniques/scene/geometry/coplanar.h) are layers in the order of their keys and do not
// shadow each other; nothing is decided by a share of the distance from the eye.
#pragma once

#include <limits>
#include <span>

#include "shaders/common/shared_shading.h"
#include "suites/truth/media/media.h"
#include "suites/truth/surface.h"
#include "suites/truth/tracer.h"
#include "techniques/scene/camera.h"
#include "techniques/scene/geometry/coplanar.h"
#include "techniques/scene/light_data.h"

namespace sb {

class RayScene {
 public:
  RayScene(const Scene& scene, uint32_t width, uint32_t height);

  /// What a camera ray meets, front to back, ending with the first opaque surface; nothing behind
  /// it. `x`, `y` in pixels, y up, centres at half integers.
  struct CameraHits {
    std::vector<TruthHit> hits;
    bool endsOpaque = false;
  };
  void cameraHits(double x, double y, CameraHits& out) const;
  /// The same at many positions; cheaper if those that follow one another are neighbours.
  void cameraHits(std::span<const glm::dvec2> positions, std::span<CameraHits* const> out) const;
  Tracer::Point point(double x, double y, const TruthHit& hit) const;

  /// Where a shadow ray ends: in a place, or nowhere.
  struct Target {
    glm::dvec3 toward;  ///< from the point: to the place, or a direction of any length
    glm::dvec3 place;   ///< relative to the eye
    bool infinite = false;
  };
  /// The light's centre.
  Target target(uint32_t light, const glm::dvec3& position) const {
    if (m_scene.lights[light].type == LightType::Directional)
      return {.toward = m_lightDirections[light], .place = glm::dvec3(0), .infinite = true};
    return {.toward = m_lightPositions[light] - position, .place = m_lightPositions[light]};
  }
  /// Product of what each surface and medium between lets through; 0 at the first opaque one.
  /// `ownNear`: the receiver's own instance does not count within that distance.
  glm::dvec3 passed(const Tracer::Point& point, const Target& target,
                    std::vector<TruthHit>& scratch, double ownNear = 0) const;
  /// `passed` of many rays; cheaper if those that follow one another are neighbours. `Rays` has
  ///   const Tracer::Point& point(size_t i) const;
  ///   Target target(size_t i) const;
  ///   double ownNear() const;
  ///   void end(size_t i, const glm::dvec3& passed);
  /// In suites/truth/lights/shadow_rays.h.
  template <class Rays>
  void pass(size_t count, Rays& rays, Bvh::PacketHits& scratch) const;
  /// Does the triangle neither shadow the point nor anything else in its plane?
  bool isOwn(uint32_t triangle, const Tracer::Point& point) const {
    return triangle == point.triangle || holds(triangle, point);
  }
  /// Is a place in the triangle's plane, as far as doubles can tell?
  bool isInPlane(uint32_t triangle, const glm::dvec3& place) const;
  /// Where the receiver's own instance lies nearest to `point` along the light, `reach` to either
  /// side; the point as if it lay there.
  std::optional<Tracer::Point> ownSurfaceAlong(uint32_t light, const Tracer::Point& point,
                                               double reach, std::vector<TruthHit>& scratch) const;
  /// Does the light reach the side of the surface that the viewer sees?
  bool reaches(uint32_t light, const Tracer::Point& point) const;
  gpu::Illumination illumination(uint32_t light, const Tracer::Point& point) const;
  /// Toward the light, unit.
  glm::dvec3 toLight(uint32_t light, const glm::dvec3& position) const;
  const std::vector<TruthTriangle>& triangles() const { return m_triangles; }
  const SurfaceTraits& traits(uint32_t triangle) const {
    return *m_instanceTraits[m_triangles[triangle].instance];
  }
  /// Farthest coordinate of anything, relative to the eye.
  double extent() const { return m_reach; }
  /// Relative to the eye; local lights.
  const glm::dvec3& lightPosition(uint32_t light) const { return m_lightPositions[light]; }

  const MediaField& media() const { return m_media; }
  /// A piece of a camera ray, between two depths as TruthHit::t counts them.
  MediaField::Stretch cameraStretch(double x, double y, double from, double to) const;

  Surface surface(const TruthHit& hit) const;
  const Scene& scene() const { return m_scene; }
  uint32_t width() const { return m_width; }
  uint32_t height() const { return m_height; }
  uint64_t bytes() const {
    return m_triangles.size() * (sizeof(TruthTriangle) + sizeof(Plane)) + m_bvh->bytes();
  }
  uint32_t lights() const { return uint32_t(m_lights.size()); }

 private:
  /// Of a facet, what tells planes that are far apart.
  struct Plane {
    glm::dvec3 normal, ulp;
  };
  TruthRay cameraRay(double x, double y) const;
  Bvh::Verdict judgeForCamera(const TruthHit& hit) const;
  /// Of what a camera ray met, leaves what the eye sees.
  void endCameraHits(CameraHits& hits) const;
  /// What a point, known to `ulp`, may be off a plane that holds it.
  static double knownTo(const Plane& plane, const glm::dvec3& ulp) {
    return 16 * glm::dot(glm::abs(plane.normal), ulp + plane.ulp);
  }
  /// From where on triangles stop shadow rays whatever else holds (Bvh).
  std::vector<double> blockingHeights() const;
  class CameraRays;
  template <class Rays>
  class ShadowRays;
  static TruthRay shadowRay(const Tracer::Point& point, const Target& target, bool stopsUnasked) {
    return {.origin = point.position,
            .direction = target.toward,
            .tMax = target.infinite ? std::numeric_limits<double>::infinity() : 1,
            .own = point.triangle,
            .stopsUnasked = stopsUnasked};
  }
  Bvh::Verdict judgeForLight(const Tracer::Point& point, const Target& target, double ownNear,
                             const TruthHit& hit) const;
  /// What a shadow ray that nothing stopped brings along.
  glm::dvec3 passedThrough(const Tracer::Point& point, const Target& target,
                           std::span<const TruthHit> hits) const;
  /// Share of light that passes a surface.
  glm::dvec3 transmittance(const TruthHit& hit) const;
  Facet facet(uint32_t triangle) const;
  /// Do two hits of a ray, whose depths differ by no more than `range`, lie in one plane?
  bool sameSurface(const TruthHit& a, const TruthHit& b, double range) const;
  void orderTies(std::vector<TruthHit>& hits, double range) const;
  /// Does the triangle's plane hold the point: as its own plane, or as one that touches it?
  bool holds(uint32_t triangle, const Tracer::Point& point) const;

  const Scene& m_scene;
  uint32_t m_width, m_height;
  const glm::dmat3 m_cameraAxes;
  const double m_cameraTangent;  ///< of half the vertical angle
  std::vector<TruthTriangle> m_triangles;
  std::vector<Plane> m_planes;  ///< of each triangle
  std::vector<SurfaceTraits> m_traits;
  std::vector<const SurfaceTraits*> m_instanceTraits;
  /// Of each instance whose surface is the same everywhere.
  std::vector<std::optional<glm::dvec3>> m_evenTransmittance;
  std::vector<gpu::LightData> m_lights;
  std::vector<glm::dvec3> m_lightPositions;
  std::vector<glm::dvec3> m_lightDirections;  ///< toward directional lights, unit
  MediaField m_media;
  double m_reach;  ///< farthest coordinate of anything
  std::unique_ptr<Bvh> m_bvh;
};

}  // namespace sb
