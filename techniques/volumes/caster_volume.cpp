#include "techniques/volumes/caster_volume.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "techniques/volumes/culling/near_pyramid.h"

namespace sb {
namespace {

/// A light and the camera, for all casters.
struct VolumeScene {
  const SceneView& view;
  const VolumeChoice& choice;
  const Light& light;
  glm::dvec4 place;  ///< relative to the eye, w 1; or the way to it, w 0
  std::array<glm::dvec3, 4> nearRectangle;
  double reach;  ///< no receiver is farther from the light (directional: from any caster)

  bool local() const { return light.type != LightType::Directional; }
  bool orthographic() const { return view.placed().camera().orthographic; }
};

/// VolumeScene::reach, of receivers that the light reaches.
double receiverReach(const SceneView& view, const Light& light) {
  const bool local = light.type != LightType::Directional;
  if (local && light.range > 0) return light.range;
  const Box all = instancesBox(view.placed(), view.camera().eye);
  if (!local) return 2 * all.radius();
  double reach = 0;
  for (int corner = 0; corner < 8; ++corner)
    reach = std::max(reach, glm::distance(all.corner(corner), light.position - view.camera().eye));
  return reach;
}

VolumeScene volumeScene(const SceneView& view, const VolumeChoice& choice, uint32_t light) {
  const Light& l = view.placed().light(light);
  const bool local = l.type != LightType::Directional;
  return {view,
          choice,
          l,
          local ? glm::dvec4(l.position - view.camera().eye, 1) : glm::dvec4(-l.direction, 0),
          nearRectangle(view.placed().camera(), view.aspect()),
          receiverReach(view, l)};
}

/// EdgeMesh::winding where it stands.
int windingOf(const VolumeScene& s, uint32_t instance, const EdgeMesh& edges) {
  const bool mirrored = s.view.instance(instance).normal0.w < 0;
  return mirrored ? -edges.winding : edges.winding;
}

/// Closed, and never seen from within while the eye is not there: rays from the eye to what they
/// show leave it as often as they enter.
bool isSolid(const VolumeScene& s, uint32_t instance, const EdgeMesh& edges) {
  const Scene& scene = s.view.scene();
  const Material& material = scene.materials[scene.meshes[scene.instances[instance].mesh].material];
  // Faces that are not shown let the eye in, where the mesh is inside out.
  return edges.closed && material.alphaMode != AlphaMode::Mask &&
         (material.doubleSided || windingOf(s, instance, edges) == 1);
}

/// How often a closed mesh encloses the light: sum of the solid angles under which it is seen from
/// there (Van Oosterom and Strackee 1983). 0: it lies outside.
int windingAroundLight(const gpu::VolumeData& volume, const Mesh& mesh) {
  double angle = 0;
  for (size_t i = 0; i < mesh.indices.size(); i += 3) {
    glm::dvec3 v[3];
    for (size_t k = 0; k < 3; ++k) {
      v[k] = gpu::lightThrough(volume, mesh.positions[mesh.indices[i + k]]);
      if (const double length = glm::length(v[k]); length > 0) v[k] /= length;
    }
    angle += 2 * std::atan2(glm::dot(v[0], glm::cross(v[1], v[2])),
                            1 + glm::dot(v[0], v[1]) + glm::dot(v[1], v[2]) + glm::dot(v[2], v[0]));
  }
  return int(std::lround(angle / (4 * std::numbers::pi)));
}

/// What is near a caster, or within.
struct Surroundings {
  bool eye = false, light = false;
};

Surroundings surroundings(const VolumeScene& s, const Box& box) {
  Box near, light;
  for (const glm::dvec3& corner : s.nearRectangle) near.add(corner);
  if (s.local()) light.add(glm::dvec3(s.place));
  return {.eye = box.touches(near), .light = s.local() && box.touches(light)};
}

/// Between two points outside a closed mesh there are as many triangles that face the light as
/// others: the others alone cast the same shadow, and leave the edge between lit and unlit facets
/// in the dark. Everything else is cast by all triangles.
uint32_t castsOf(const VolumeScene& s, const Surroundings& near, bool solid) {
  return s.choice.casts.value_or(solid && !near.eye && !near.light ? CASTS_BACK : CASTS_ALL);
}

/// VolumeChoice::addsUp: one side of a closed mesh is right wherever receivers are. Where the light
/// is outside, that through which its ways enter; where it is within, that through which they
/// leave.
uint32_t oneSideOf(const Surroundings& near, bool solid, const gpu::VolumeData& volume,
                   const Mesh& mesh, bool insideOut) {
  if (near.light)
    if (const int winding = windingAroundLight(volume, mesh); winding != 0)
      return winding > 0 ? CASTS_BACK : CASTS_LIGHT;
  // Nothing within is seen: as castsOf.
  if (solid && !near.eye) return CASTS_BACK;
  return insideOut ? CASTS_BACK : CASTS_LIGHT;
}

/// VolumeData::extent.
float extentOf(const VolumeScene& s, const Box& box) {
  if (s.choice.finite) return float(s.reach);
  if (!s.orthographic()) return 0;
  // Volumes are scaled from the light, so their least distance grows to the reach. Around a light
  // within the caster's box, triangles are taken to be no nearer than a small part of it.
  const glm::dvec3 light(s.place);
  const double distance = glm::distance(light, glm::clamp(light, box.low, box.high));
  const double least = s.local() ? std::max(distance, box.radius() * 0x1p-12) : 1;
  // A caster beyond the light's reach still ends behind itself.
  return float(std::min(least / (1.01 * s.reach), 0.5));
}

/// CasterVolume::caps, counted behind the receiver: before the near plane nothing is.
std::vector<uint32_t> capsOf(const VolumeScene& s, const Box& box) {
  const Camera& camera = s.view.placed().camera();
  const glm::dvec3 forward = -glm::dvec3(camera.toWorld[2]);
  double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
  for (int i = 0; i < 8; ++i) {
    const double depth = glm::dot(forward, box.corner(i));
    nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
  }
  if (nearest > camera.nearPlane && farthest < camera.farPlane) return {CAPS_BOTH};
  if (farthest < camera.farPlane) return {CAPS_NEAR, CAPS_FAR};
  return {CAPS_NEAR, CAPS_BEYOND, CAPS_FAR};
}

CasterVolume casterVolume(const VolumeScene& s, const EdgeBuffers& edges, uint32_t instance) {
  const uint32_t mesh = s.view.scene().instances[instance].mesh;
  const EdgeBuffers::MeshEdges& e = edges.of(mesh);
  Box box = instanceBox(s.view.placed(), instance, s.view.camera().eye);
  box.grow(1e-6 * (glm::length(box.center()) + box.radius()));
  const bool solid = isSolid(s, instance, e.mesh);
  const bool meets = meetsNearPyramid(s.nearRectangle, s.place, box.center(), box.radius());
  CasterVolume v{.instance = instance,
                 .mesh = mesh,
                 .count = s.choice.count.value_or(meets ? DepthCount::Fail : DepthCount::Pass),
                 .parts = {VOLUME_SIDES}};
  const float extent = extentOf(s, box);
  const gpu::InstanceData& placed = s.view.instance(instance);
  const glm::dvec3 origin(s.view.placed().toWorld(instance)[3]);
  const bool point = !s.local() && extent == 0;
  v.data = {.row0 = placed.toRelative0,
            .row1 = placed.toRelative1,
            .row2 = placed.toRelative2,
            .light = s.local() ? glm::vec4(glm::vec3(origin - s.light.position), 1)
                               : glm::vec4(glm::vec3(s.light.direction), 0),
            .extent = glm::vec4(glm::vec3(s.place), extent),
            .first = {e.edges.first, e.corners.first, e.positions.first, 0},
            .lists = {},
            .counts = {e.edgeCount, e.triangleCount, 0, 0},
            .vertices = {point ? 3 : 6, point ? 3 : 6, 0, 0}};
  const Surroundings near = surroundings(s, box);
  const uint32_t casts = s.choice.addsUp && e.mesh.closed
                             ? oneSideOf(near, solid, v.data, s.view.scene().meshes[mesh],
                                         windingOf(s, instance, e.mesh) < 0)
                             : castsOf(s, near, solid);
  v.data.counts.z = casts;
  v.data.counts.w = e.mesh.closed && casts != CASTS_ALL ? 1 : 2;
  // Counting before the receiver ends at the caster itself, where that is seen whole, and as part
  // of a solid; unless the volume has a far end.
  if (v.count == DepthCount::Fail || extent > 0 || !solid) {
    if (casts != CASTS_BACK) v.parts.push_back(VOLUME_CAPS);
    if (casts != CASTS_LIGHT) v.parts.push_back(VOLUME_TURNED);
  }
  if (v.count == DepthCount::Fail) v.caps = capsOf(s, box);
  std::vector<uint32_t> listed = v.parts;
  if (s.choice.addsUp) listed = {VOLUME_SIDES, VOLUME_CAPS, VOLUME_TURNED};
  for (const uint32_t part : listed) {
    v.data.vertices.z |= 1u << part;
    v.items[part] = part == VOLUME_SIDES ? e.edgeCount * v.data.counts.w : e.triangleCount;
  }
  return v;
}

}  // namespace

std::vector<LightVolumes> lightVolumes(const SceneView& view, const EdgeBuffers& edges,
                                       const VolumeChoice& choice,
                                       const std::vector<LightCasters>& lights) {
  std::vector<LightVolumes> volumes;
  uint32_t number = 0;
  for (const LightCasters& light : lights) {
    const VolumeScene scene = volumeScene(view, choice, light.light);
    LightVolumes& made = volumes.emplace_back(
        LightVolumes{.light = light.light, .casters = {}, .scissor = light.scissor});
    for (const uint32_t instance : light.instances)
      made.casters.emplace_back(casterVolume(scene, edges, instance)).number = number++;
  }
  return volumes;
}

}  // namespace sb
