#include "tests/techniques/tracer.h"

#include <cmath>
#include <sstream>

#include "techniques/scene/optics.h"

namespace sb::test {

Tracer::Tracer(const Scene& scene) : m_scene(scene) {
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    if (materialTraits(scene, scene.materials[mesh.material]).lightClass != MaterialClass::Opaque)
      continue;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      glm::dvec3 p[3];
      for (size_t c = 0; c < 3; ++c)
        p[c] = instance.toWorld * glm::dvec4(mesh.positions[mesh.indices[i + c]], 1);
      const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
      if (glm::length(n) > 0)
        m_triangles.push_back({p[0], p[1] - p[0], p[2] - p[0], glm::normalize(n)});
    }
  }
}

std::optional<std::pair<double, size_t>> Tracer::nearest(const glm::dvec3& origin,
                                                         const glm::dvec3& dir, double from,
                                                         double to,
                                                         const SurfacePoint* skip) const {
  std::optional<std::pair<double, size_t>> best;
  for (size_t i = 0; i < m_triangles.size(); ++i) {
    const Triangle& t = m_triangles[i];
    if (skip && std::abs(glm::dot(t.normal, skip->normal)) > 1 - 1e-9 &&
        std::abs(glm::dot(skip->normal, skip->position - t.a)) < 1e-10)
      continue;
    const glm::dvec3 h = glm::cross(dir, t.ac);
    const double det = glm::dot(t.ab, h);
    if (det == 0) continue;
    const glm::dvec3 s = origin - t.a, q = glm::cross(s, t.ab);
    const double u = glm::dot(s, h) / det, v = glm::dot(dir, q) / det;
    if (u < 0 || v < 0 || u + v > 1) continue;
    const double distance = glm::dot(t.ac, q) / det;
    if (distance > from && distance < to) {
      to = distance;
      best = {distance, i};
    }
  }
  return best;
}

std::optional<SurfacePoint> Tracer::pixel(uint32_t x, uint32_t y, rhi::Extent2D size) const {
  const Camera& camera = m_scene.camera();
  const double aspect = double(size.width) / size.height;
  const double nx = (2 * (x + 0.5) / size.width - 1) * aspect, ny = 2 * (y + 0.5) / size.height - 1;
  const double h = camera.orthographic ? camera.halfHeight : std::tan(camera.fovY / 2);
  const glm::dmat3 axes(camera.toWorld);
  glm::dvec3 origin = camera.eye(), dir = axes * glm::dvec3(nx * h, ny * h, -1);
  if (camera.orthographic) {
    origin += axes * glm::dvec3(nx * h, ny * h, 0);
    dir = axes * glm::dvec3(0, 0, -1);
  }
  // The parameter of the ray is the view depth.
  const auto hit = nearest(origin, dir, camera.nearPlane, camera.farPlane, nullptr);
  if (!hit) return {};
  return SurfacePoint{origin + hit->first * dir, m_triangles[hit->second].normal};
}

Shadow Tracer::shadow(const SurfacePoint& point, const Light& light, double radius,
                      double contact) const {
  const bool local = light.type != LightType::Directional;
  const glm::dvec3 middle = local ? light.position - point.position : -light.direction;
  const glm::dvec3 axis = glm::normalize(middle);
  const glm::dvec3 side = glm::normalize(
      glm::cross(axis, std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 other = glm::cross(axis, side);
  constexpr int kSteps = 3;
  size_t dark = 0, rays = 0;
  for (int j = -kSteps; j <= kSteps; ++j)
    for (int i = -kSteps; i <= kSteps; ++i) {
      // Moved aside, then along the light back onto the receiver's plane.
      const glm::dvec3 offset = (side * double(i) + other * double(j)) * (radius / kSteps);
      const double lean = glm::dot(point.normal, axis);
      if (std::abs(lean) < 1e-9) return Shadow::Unsure;
      const glm::dvec3 from =
          point.position + offset - axis * (glm::dot(point.normal, offset) / lean);
      const glm::dvec3 to = local ? light.position - from : axis;
      const double length = local ? glm::length(to) : 1e300;
      const auto hit = nearest(from, glm::normalize(to), 0, length, &point);
      if (hit && hit->first < contact) return Shadow::Unsure;
      dark += hit.has_value();
      ++rays;
    }
  return dark == 0 ? Shadow::Lit : dark == rays ? Shadow::Dark : Shadow::Unsure;
}

ShadowCounts compareShadows(Cell& cell, uint32_t light, double texels, double contact) {
  const Tracer tracer(cell.scene());
  const Light& source = cell.scene().lights[light];
  std::vector<LightView> views = cell.lightViews();
  double texelAtOne = 0;
  for (const LightView& view : views)
    if (view.light == light && view.layer >= 0)
      texelAtOne = std::max(texelAtOne, double(view.texelWidth));
  const VisibilityImage& image = cell.visibility(light)[0];
  ShadowCounts counts;
  const auto [width, height] = cell.size();
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      const auto point = tracer.pixel(x, y, cell.size());
      const float* v = image.data() + 4 * (size_t(y) * width + x);
      if (!point || v[3] == 0) continue;
      double texel = texelAtOne;
      if (source.type != LightType::Directional) {
        const glm::dvec3 d = glm::abs(point->position - source.position);
        texel *= source.type == LightType::Point
                     ? std::max({d.x, d.y, d.z})
                     : std::abs(glm::dot(point->position - source.position, source.direction));
      }
      const Shadow truth = tracer.shadow(*point, source, texels * texel, contact);
      (truth == Shadow::Lit ? counts.lit : truth == Shadow::Dark ? counts.dark : counts.unsure)++;
      if (truth == Shadow::Unsure) continue;
      const float expected = truth == Shadow::Lit ? 1.0f : 0.0f;
      if (v[0] == expected && v[1] == expected && v[2] == expected) continue;
      if (counts.wrong++ == 0) {
        std::ostringstream text;
        text << "pixel " << x << ", " << y << " at (" << point->position.x << ", "
             << point->position.y << ", " << point->position.z << "): " << v[0] << ", expected "
             << expected;
        counts.firstWrong = text.str();
      }
    }
  return counts;
}

}  // namespace sb::test
