#include "techniques/scene/box.h"

namespace sb {

Box transformedBox(const Box& box, const glm::dmat4& toWorld, const glm::dvec3& origin,
                   const glm::dmat3& axes) {
  const glm::dmat3 linear = axes * glm::dmat3(toWorld);
  const glm::dvec3 shift = axes * (glm::dvec3(toWorld[3]) - origin);
  Box around;
  for (int i = 0; i < 8; ++i) around.add(linear * box.corner(i) + shift);
  return around;
}

Box meshBox(const Mesh& mesh) { return {mesh.boundsMin, mesh.boundsMax}; }

Box instanceBox(const Scene& scene, const Instance& instance, const glm::dvec3& origin) {
  return transformedBox(meshBox(scene.meshes.at(instance.mesh)), instance.toWorld, origin);
}

Box instanceBox(const PlacedScene& placed, uint32_t instance, const glm::dvec3& origin,
                const glm::dmat3& axes) {
  const Scene& scene = placed.scene();
  return transformedBox(meshBox(scene.meshes[scene.instances[instance].mesh]),
                        placed.toWorld(instance), origin, axes);
}

Box instancesBox(const PlacedScene& placed, const glm::dvec3& origin) {
  Box box;
  for (uint32_t i = 0; i < placed.scene().instances.size(); ++i)
    box.add(instanceBox(placed, i, origin));
  return box;
}

Box sceneBox(const Scene& scene) {
  Box box;
  for (const Instance& instance : scene.instances) box.add(instanceBox(scene, instance));
  for (const Medium& medium : scene.media) box.add(transformedBox(kMediumBox, medium.boxToWorld));
  return box;
}

}  // namespace sb
