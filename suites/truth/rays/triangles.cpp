#include "suites/truth/rays/triangles.h"

namespace sb {

std::vector<TruthTriangle> truthTriangles(const Scene& scene, const glm::dvec3& eye) {
  std::vector<TruthTriangle> triangles;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.meshes[instance.mesh];
    const glm::dmat3 linear(instance.toWorld);
    const glm::dvec3 translation = glm::dvec3(instance.toWorld[3]) - eye;
    std::vector<glm::dvec3> positions;
    positions.reserve(mesh.positions.size());
    for (const glm::vec3& p : mesh.positions)
      positions.push_back(linear * glm::dvec3(p) + translation);
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      TruthTriangle& triangle = triangles.emplace_back();
      for (size_t c = 0; c < 3; ++c) triangle.corners[c] = positions[mesh.indices[3 * t + c]];
      triangle.instance = i;
      triangle.number = t;
    }
  }
  return triangles;
}

}  // namespace sb
