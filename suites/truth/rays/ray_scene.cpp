#include "suites/truth/rays/ray_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "suites/truth/rays/ray_packet.h"
#include "techniques/scene/light_area.h"

namespace sb {
namespace {

using glm::dvec3;

double extentOf(const std::vector<TruthTriangle>& triangles, const std::vector<Light>& lights,
                const std::vector<dvec3>& positions) {
  double extent = 0;
  const auto add = [&](const dvec3& p, double size = 0) {
    extent = std::max(extent, size + std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
  };
  for (const TruthTriangle& t : triangles)
    for (const dvec3& p : t.corners) add(p);
  // Rays end all over a lamp.
  for (size_t i = 0; i < lights.size(); ++i)
    if (lights[i].type != LightType::Directional) add(positions[i], lightRadius(lights[i]));
  return extent;
}

/// Coplanar surfaces meet a ray at depths that differ by what their coordinates are rounded to, more
/// at grazing angles: only within this share of the scene's size are planes compared at all.
constexpr double kTieRange = 1e-4;

/// Is a point in a triangle's plane, as far as doubles can tell? It is on an edge that surfaces
/// share, or a light in a ceiling: which side rounding puts it on must not matter.
bool touches(const TruthTriangle& t, const dvec3& point) {
  const dvec3 n = glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
  const dvec3 size = glm::abs(point) + glm::abs(t.corners[0]);
  return std::abs(glm::dot(n, point - t.corners[0])) <= 0x1p-50 * glm::dot(glm::abs(n), size);
}

}  // namespace

RayScene::RayScene(const Scene& scene, uint32_t width, uint32_t height)
    : m_scene(scene),
      m_width(width),
      m_height(height),
      m_cameraAxes(scene.camera().toWorld),
      m_cameraTangent(std::tan(scene.camera().fovY / 2)),
      m_triangles(truthTriangles(scene, scene.camera().eye())),
      m_traits(surfaceTraits(scene)),
      m_media(scene, scene.camera().eye()) {
  const dvec3 eye = scene.camera().eye();
  for (uint32_t i = 0; i < scene.lights.size(); ++i) {
    m_lights.push_back(lightData(scene.lights[i], i, eye));
    m_lightDirections.push_back(-glm::normalize(scene.lights[i].direction));
    m_lightPositions.push_back(scene.lights[i].type == LightType::Directional
                                   ? dvec3(0)
                                   : scene.lights[i].position - eye);
  }
  for (const Instance& instance : scene.instances)
    m_instanceTraits.push_back(&m_traits[scene.meshes[instance.mesh].material]);
  m_evenTransmittance.resize(scene.instances.size());
  m_planes.reserve(m_triangles.size());
  for (const TruthTriangle& t : m_triangles) {
    const Surface surface(scene, m_traits, t, {});
    if (t.number == 0 && surface.isEven())
      m_evenTransmittance[t.instance] = surface.transmittance();
    const Facet f = facetOf(scene, t.instance, t.number, eye);
    m_planes.push_back({f.normal, f.ulp});
  }
  m_reach = extentOf(m_triangles, scene.lights, m_lightPositions);
  const Camera& c = scene.camera();
  const double picture = c.orthographic ? c.halfHeight * (1 + double(width) / height) : 0;
  m_bvh = std::make_unique<Bvh>(m_triangles, std::max(m_reach, picture), blockingHeights());
}

std::vector<double> RayScene::blockingHeights() const {
  dvec3 ulp(0);
  for (const Plane& plane : m_planes) ulp = glm::max(ulp, plane.ulp);
  std::vector<double> heights;
  heights.reserve(m_triangles.size());
  for (uint32_t i = 0; i < m_triangles.size(); ++i)
    heights.push_back(traits(i).blocks ? knownTo(m_planes[i], ulp) : HUGE_VAL);
  return heights;
}

dvec3 RayScene::transmittance(const TruthHit& hit) const {
  const auto& even = m_evenTransmittance[m_triangles[hit.triangle].instance];
  return even ? *even : surface(hit).transmittance();
}

Surface RayScene::surface(const TruthHit& hit) const {
  return {m_scene, m_traits, m_triangles[hit.triangle], hit};
}

TruthRay RayScene::cameraRay(double x, double y) const {
  const Camera& c = m_scene.camera();
  const double aspect = double(m_width) / m_height;
  const double u = (2 * x / m_width - 1) * aspect, v = 2 * y / m_height - 1;
  TruthRay ray{.tMin = c.nearPlane, .tMax = c.farPlane, .tie = kTieRange * m_reach};
  // The direction's depth is 1: t is the depth that near and far planes cut.
  if (c.orthographic) {
    ray.origin = m_cameraAxes * dvec3(u * c.halfHeight, v * c.halfHeight, 0);
    ray.direction = m_cameraAxes * dvec3(0, 0, -1);
  } else {
    ray.origin = dvec3(0);
    ray.direction = m_cameraAxes * dvec3(u * m_cameraTangent, v * m_cameraTangent, -1);
  }
  return ray;
}

MediaField::Stretch RayScene::cameraStretch(double x, double y, double from, double to) const {
  const TruthRay ray = cameraRay(x, y);
  const double length = glm::length(ray.direction);
  return {ray.origin, ray.direction / length, from * length, to * length};
}

Bvh::Verdict RayScene::judgeForCamera(const TruthHit& hit) const {
  const SurfaceTraits& traits = this->traits(hit.triangle);
  if (traits.material.cameraTranslucent)
    return surface(hit).optics().alpha > 0 ? Bvh::Verdict::Keep : Bvh::Verdict::Ignore;
  // As glTF asks and the rasteriser culls: no back faces of single-sided surfaces.
  if (!traits.doubleSided && !hit.front) return Bvh::Verdict::Ignore;
  if (traits.masked && surface(hit).optics().alpha <= 0) return Bvh::Verdict::Ignore;
  return Bvh::Verdict::Nearest;
}

void RayScene::cameraHits(double x, double y, CameraHits& out) const {
  CameraHits* const hits = &out;
  const glm::dvec2 position(x, y);
  cameraHits(std::span(&position, 1), std::span(&hits, 1));
}

class RayScene::CameraRays {
 public:
  CameraRays(const RayScene& scene, std::span<const glm::dvec2> positions,
             std::span<CameraHits* const> out)
      : m_scene(scene), m_positions(positions), m_out(out) {}
  TruthRay ray(size_t i) const { return m_scene.cameraRay(m_positions[i].x, m_positions[i].y); }
  Bvh::Verdict judge(size_t, const TruthHit& hit) const { return m_scene.judgeForCamera(hit); }
  void end(size_t i, bool, std::vector<TruthHit>& hits) {
    m_out[i]->hits.swap(hits);
    m_scene.endCameraHits(*m_out[i]);
  }

 private:
  const RayScene& m_scene;
  std::span<const glm::dvec2> m_positions;
  std::span<CameraHits* const> m_out;
};

void RayScene::cameraHits(std::span<const glm::dvec2> positions,
                          std::span<CameraHits* const> out) const {
  Bvh::PacketHits scratch;
  CameraRays rays(*this, positions, out);
  m_bvh->hits(positions.size(), rays, scratch);
}

void RayScene::endCameraHits(CameraHits& out) const {
  const auto endsRay = [&](const TruthHit& hit) {
    return !traits(hit.triangle).material.cameraTranslucent;
  };
  const double range = kTieRange * m_reach;
  orderTies(out.hits, range);
  // Of opaque surfaces in one plane the first ends the ray; translucent ones in it are no layers.
  const auto opaque = std::ranges::find_if(out.hits, endsRay);
  out.endsOpaque = opaque != out.hits.end();
  if (!out.endsOpaque) return;
  const TruthHit end = *opaque;
  std::erase_if(out.hits, [&](const TruthHit& hit) {
    return endsRay(hit) || hit.t > end.t || sameSurface(hit, end, range);
  });
  out.hits.push_back(end);
}

Facet RayScene::facet(uint32_t triangle) const {
  const TruthTriangle& t = m_triangles[triangle];
  return facetOf(m_scene, t.instance, t.number, m_scene.camera().eye());
}

bool RayScene::sameSurface(const TruthHit& a, const TruthHit& b, double range) const {
  return std::abs(a.t - b.t) <= range && coplanar(facet(a.triangle), facet(b.triangle));
}

void RayScene::orderTies(std::vector<TruthHit>& hits, double range) const {
  const auto order = [&](const TruthHit& hit) {
    const TruthTriangle& t = m_triangles[hit.triangle];
    return surfaceOrder(m_scene, t.instance, t.number);
  };
  for (size_t first = 0; first + 1 < hits.size();) {
    size_t end = first + 1;
    while (end < hits.size() && sameSurface(hits[first], hits[end], range)) ++end;
    const auto tied = std::ranges::subrange(hits.begin() + std::ptrdiff_t(first),
                                            hits.begin() + std::ptrdiff_t(end));
    // At one depth, so that nothing comes between them.
    if (end - first > 1) {
      const double t = hits[first].t;
      std::ranges::sort(tied, {}, order);
      for (TruthHit& hit : tied) hit.t = t;
    }
    first = end;
  }
}

Tracer::Point RayScene::point(double x, double y, const TruthHit& hit) const {
  const TruthRay ray = cameraRay(x, y);
  const TruthTriangle& t = m_triangles[hit.triangle];
  const dvec3 n =
      glm::normalize(glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]));
  dvec3 p = ray.origin + hit.t * ray.direction;
  // Into the plane again, as nearly as doubles can say.
  p -= n * glm::dot(n, p - t.corners[0]);
  // Toward the eye, as the shaders turn it, for orthographic cameras too.
  return {.position = p,
          .normal = glm::dot(n, p) > 0 ? -n : n,
          .instance = t.instance,
          .triangle = hit.triangle,
          .translucent = traits(hit.triangle).material.lightClass == MaterialClass::Translucent};
}

dvec3 RayScene::toLight(uint32_t light, const dvec3& position) const {
  if (m_scene.lights[light].type == LightType::Directional) return m_lightDirections[light];
  return glm::normalize(m_lightPositions[light] - position);
}

gpu::Illumination RayScene::illumination(uint32_t light, const Tracer::Point& point) const {
  return gpu::illumination(m_lights[light], glm::vec3(point.position));
}

bool RayScene::reaches(uint32_t light, const Tracer::Point& point) const {
  if (!(glm::dot(point.normal, toLight(light, point.position)) > 0)) return false;
  return glm::any(glm::greaterThan(illumination(light, point).radiance, glm::vec3(0)));
}

bool RayScene::holds(uint32_t triangle, const Tracer::Point& point) const {
  const TruthTriangle& t = m_triangles[triangle];
  if (touches(t, point.position)) return true;
  if (point.triangle == kNone) return false;
  // Near enough for its plane to be the same one?
  const Plane &own = m_planes[point.triangle], &other = m_planes[triangle];
  const double height = glm::dot(other.normal, point.position - t.corners[0]);
  return std::abs(height) <= knownTo(other, own.ulp) &&
         coplanar(facet(point.triangle), facet(triangle));
}

bool RayScene::isInPlane(uint32_t triangle, const dvec3& place) const {
  return touches(m_triangles[triangle], place);
}

std::optional<Tracer::Point> RayScene::ownSurfaceAlong(uint32_t light, const Tracer::Point& point,
                                                       double reach,
                                                       std::vector<TruthHit>& scratch) const {
  const dvec3 direction = toLight(light, point.position);
  const TruthRay ray{.origin = point.position - reach * direction,
                     .direction = direction,
                     .tMin = 0,
                     .tMax = 2 * reach};
  m_bvh->hits(ray,
              [&](const TruthHit& hit) {
                return m_triangles[hit.triangle].instance == point.instance
                           ? Bvh::Verdict::Keep
                           : Bvh::Verdict::Ignore;
              },
              scratch);
  if (scratch.empty()) return {};
  const TruthHit& nearest = *std::ranges::min_element(
      scratch, {}, [&](const TruthHit& hit) { return std::abs(hit.t - reach); });
  Tracer::Point at = point;
  at.position = ray.origin + nearest.t * direction;
  at.triangle = nearest.triangle;
  return at;
}

}  // namespace sb
