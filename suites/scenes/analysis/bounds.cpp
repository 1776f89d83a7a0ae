#include "suites/scenes/analysis/bounds.h"

namespace sb {

Bounds transformedBox(glm::dvec3 low, glm::dvec3 high, const glm::dmat4& toWorld, glm::dvec3 origin) {
  const Bounds mesh{low, high};
  const glm::dmat3 linear(toWorld);
  const glm::dvec3 shift = glm::dvec3(toWorld[3]) - origin;
  Bounds box;
  for (int i = 0; i < 8; ++i) box.add(linear * mesh.corner(i) + shift);
  return box;
}

Bounds instanceBox(const Scene& scene, const Instance& instance, glm::dvec3 origin) {
  const Mesh& mesh = scene.meshes.at(instance.mesh);
  return transformedBox(mesh.boundsMin, mesh.boundsMax, instance.toWorld, origin);
}

Bounds sceneBox(const Scene& scene) {
  Bounds box;
  for (const Instance& instance : scene.instances) box.add(instanceBox(scene, instance));
  for (const Medium& medium : scene.media)
    box.add(transformedBox(glm::dvec3(0), glm::dvec3(1), medium.boxToWorld));
  return box;
}

}  // namespace sb
