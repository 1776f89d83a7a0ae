#include "techniques/volumes/culling/shadow_culling.h"

#include <algorithm>
#include <cmath>

#include "techniques/scene/light_area.h"
#include "techniques/scene/optics.h"
#include "techniques/volumes/culling/light_rectangle.h"

namespace sb {
namespace {

// Weights of importance (thesis, section 5.4): a volume that fills the picture counts as much as
// one at a hundredth of the scene's size from the eye.
constexpr double kAreaWeight = 1, kNearWeight = 0.01;

std::vector<uint32_t> allCasters(const Scene& scene) {
  std::vector<uint32_t> casters;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    if (mesh.triangleCount() > 0 &&
        materialTraits(scene, scene.materials[mesh.material]).lightClass !=
            MaterialClass::Translucent)
      casters.push_back(i);
  }
  return casters;
}

/// Share of the picture that a box (relative to the eye) takes at most.
double shareOfPicture(const SceneView& view, const Box& box) {
  const Camera& camera = view.placed().camera();
  Box picture;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec4 clip = view.camera().viewProjection * glm::dvec4(box.corner(i), 1);
    // What reaches behind the eye may be anywhere.
    if (!camera.orthographic && clip.w < camera.nearPlane) return 1;
    picture.add(glm::dvec3(clip.x / clip.w, clip.y / clip.w, 0));
  }
  picture = picture.clippedTo({glm::dvec3(-1, -1, 0), glm::dvec3(1, 1, 0)});
  if (picture.empty()) return 0;
  return 0.25 * (picture.high.x - picture.low.x) * (picture.high.y - picture.low.y);
}

/// VolumeBounds::lightRadius, as receivers in a box relative to the eye see the light.
double radiusOf(const Light& light, const Box& receivers, const glm::dvec3& eye) {
  if (light.type == LightType::Directional) return std::sin(light.angularRadius);
  const glm::dvec3 place = light.position - eye;
  const double distance = glm::distance(place, glm::clamp(place, receivers.low, receivers.high));
  return seenRadius(light.shape, lightRadius(light), distance);
}

Box moved(const Box& box, const glm::dvec3& by) { return {box.low + by, box.high + by}; }

}  // namespace

std::vector<uint32_t> volumeCasters(const LightEffects& light) {
  std::vector<uint32_t> casters;
  if (!light.touchesView) return casters;
  std::ranges::set_union(light.opaqueCasters, light.perforatedCasters, std::back_inserter(casters));
  return casters;
}

std::vector<std::pair<std::string, uint64_t>> namedCounts(const CullingCounts& counts) {
  static constexpr std::array kFates = {"of unseen lights", "out of reach", "out of view",
                                        "off receivers",    "over budget",  "drawn"};
  static_assert(kFates.size() == size_t(VolumeFate::Count));
  std::vector<std::pair<std::string, uint64_t>> named = {{"lights", counts.lights},
                                                         {"lights unseen", counts.unseenLights},
                                                         {"culling box tests", counts.boxTests}};
  for (size_t i = 0; i < kFates.size(); ++i) {
    named.emplace_back("volumes " + std::string(kFates[i]), counts.fates[i].volumes);
    named.emplace_back("caster triangles " + std::string(kFates[i]), counts.fates[i].triangles);
  }
  return named;
}

ShadowCulling::ShadowCulling(const SceneView& view, const CullingChoice& choice)
    : m_view(view), m_choice(choice) {
  const Scene& scene = view.scene();
  for (const LightEffects& light : view.effects().lights) {
    std::vector<uint32_t> casters = volumeCasters(light);
    if (!choice.cull && light.touchesView) casters = allCasters(scene);
    if (!casters.empty()) m_all.push_back({.light = light.light, .instances = std::move(casters)});
  }
  for (uint32_t i = 0; i < scene.instances.size(); ++i) m_boxes.push_back(placedBox(i));
  std::vector<Box> lights;
  for (uint32_t i = 0; i < scene.lights.size(); ++i) lights.push_back(lightBox(i));
  m_instances = makeSceneTree(choice.tree, m_boxes);
  m_lights = makeSceneTree(choice.tree, lights);
  Box all;
  for (const Box& box : m_boxes) all.add(box);
  m_size = all.empty() ? 0 : all.radius();
}

Box ShadowCulling::placedBox(uint32_t instance) const {
  return instanceBox(m_view.placed(), instance, glm::dvec3(0));
}

std::optional<Sphere> ShadowCulling::reachOf(uint32_t light) const {
  const Light& l = m_view.placed().light(light);
  if (l.type == LightType::Directional || !(l.range > 0)) return {};
  return Sphere{l.position, l.range};
}

/// Lights without end are in no tree.
Box ShadowCulling::lightBox(uint32_t light) const {
  const std::optional<Sphere> reach = reachOf(light);
  if (!reach) return {};
  return {reach->center - reach->radius, reach->center + reach->radius};
}

void ShadowCulling::place() {
  for (const uint32_t i : m_view.moving().instances) {
    m_boxes[i] = placedBox(i);
    m_instances->place(i, m_boxes[i]);
  }
  if (!m_view.moving().lights) return;
  for (uint32_t i = 0; i < m_view.scene().lights.size(); ++i)
    if (m_view.scene().lights[i].pose != kNone) m_lights->place(i, lightBox(i));
}

uint64_t ShadowCulling::triangles(uint32_t instance) const {
  const Scene& scene = m_view.scene();
  return scene.meshes[scene.instances[instance].mesh].triangleCount();
}

void ShadowCulling::count(VolumeFate fate, uint64_t triangles) {
  CullingCounts::Volumes& counted = m_counts[fate];
  ++counted.volumes;
  counted.triangles += triangles;
}

void ShadowCulling::query(const SceneTree& tree, const ConvexRegion& region,
                          std::vector<uint32_t>& found) {
  found.clear();
  m_counts.boxTests += tree.query(region, found);
  std::ranges::sort(found);
}

Box ShadowCulling::receivers(const ConvexRegion& seen, const std::optional<Sphere>& reach) {
  ConvexRegion lit = seen;
  lit.sphere = reach;
  std::vector<uint32_t> found;
  query(*m_instances, lit, found);
  Box box;
  for (const uint32_t i : found) box.add(m_boxes[i]);
  if (reach) box = box.clippedTo({reach->center - reach->radius, reach->center + reach->radius});
  return moved(box, -m_view.camera().eye);
}

void ShadowCulling::cull(const LightCasters& light, const ConvexRegion& seen,
                         std::vector<Volume>& kept) {
  const glm::dvec3& eye = m_view.camera().eye;
  const Light& l = m_view.placed().light(light.light);
  const std::optional<Sphere> reach = reachOf(light.light);
  const Box receivers = this->receivers(seen, reach);
  if (receivers.empty()) {
    ++m_counts.unseenLights;
    for (const uint32_t i : light.instances) count(VolumeFate::LightUnseen, triangles(i));
    return;
  }
  const double radius = m_choice.extents ? radiusOf(l, receivers, eye) : 0;
  std::vector<uint32_t> reached = light.instances;
  // What lies between a receiver in reach and a point of the light is in reach, or beside the
  // light.
  if (reach && std::isfinite(radius))
    query(*m_instances, {.sphere = Sphere{reach->center, std::max(reach->radius, radius)}},
          reached);
  const std::vector<HalfSpace> sides = boxHalfSpaces(receivers);
  auto at = reached.begin();
  for (const uint32_t i : light.instances) {
    at = std::lower_bound(at, reached.end(), i);
    const uint64_t triangles = this->triangles(i);
    if (at == reached.end() || *at != i) {
      count(VolumeFate::OutOfReach, triangles);
      continue;
    }
    const VolumeBounds bounds{moved(m_boxes[i], -eye),
                              l.type == LightType::Directional ? glm::dvec4(-l.direction, 0)
                                                               : glm::dvec4(l.position - eye, 1),
                              radius};
    if (bounds.liesOutside(seen.halfSpaces))
      count(VolumeFate::OutOfView, triangles);
    else if (bounds.liesOutside(sides))
      count(VolumeFate::OffReceivers, triangles);
    else
      kept.push_back({light.light, i, triangles, bounds, reach ? reach->radius : 2 * m_size});
  }
}

double ShadowCulling::importance(const Volume& volume) const {
  const Box box = volume.bounds.within(volume.reach);
  const double distance = std::max(glm::length(box.center()), 1e-3 * m_size);
  return kAreaWeight * shareOfPicture(m_view, box) + kNearWeight * m_size / distance;
}

void ShadowCulling::keepWithinBudget(std::vector<Volume>& volumes) {
  if (m_choice.budget == 0) return;
  std::vector<std::pair<double, size_t>> order;
  for (size_t i = 0; i < volumes.size(); ++i) order.emplace_back(-importance(volumes[i]), i);
  std::ranges::sort(order);
  uint64_t left = m_choice.budget;
  std::vector<size_t> kept;
  for (const auto& [_, i] : order) {
    if (volumes[i].triangles > left) {
      count(VolumeFate::OverBudget, volumes[i].triangles);
      continue;
    }
    left -= volumes[i].triangles;
    kept.push_back(i);
  }
  std::ranges::sort(kept);
  std::vector<Volume> within;
  for (const size_t i : kept) within.push_back(volumes[i]);
  volumes = std::move(within);
}

std::vector<LightCasters> ShadowCulling::casters() {
  m_counts = {.lights = m_all.size()};
  if (!m_choice.cull) {
    for (const LightCasters& light : m_all)
      for (const uint32_t i : light.instances) count(VolumeFate::Drawn, triangles(i));
    return m_all;
  }
  place();
  const Camera& camera = m_view.placed().camera();
  const ConvexRegion seen{.origin = m_view.camera().eye,
                          .halfSpaces = frustumHalfSpaces(camera, m_view.aspect())};
  std::vector<uint32_t> inView;
  query(*m_lights, seen, inView);
  std::vector<Volume> volumes;
  for (const LightCasters& light : m_all) {
    if (!reachOf(light.light) || std::ranges::binary_search(inView, light.light)) {
      cull(light, seen, volumes);
      continue;
    }
    ++m_counts.unseenLights;
    for (const uint32_t i : light.instances) count(VolumeFate::LightUnseen, triangles(i));
  }
  keepWithinBudget(volumes);
  std::vector<LightCasters> lights;
  for (const Volume& volume : volumes) {
    count(VolumeFate::Drawn, volume.triangles);
    if (lights.empty() || lights.back().light != volume.light) {
      LightCasters& light = lights.emplace_back(LightCasters{.light = volume.light});
      if (std::optional<Sphere> reach = reachOf(volume.light)) {
        reach->center -= m_view.camera().eye;
        light.scissor = sphereRectangle(camera, m_view.size(), *reach);
      }
    }
    lights.back().instances.push_back(volume.instance);
  }
  return lights;
}

}  // namespace sb
