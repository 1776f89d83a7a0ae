#include "suites/scenes/edit/framing.h"

#include <algorithm>
#include <cmath>

#include "suites/scenes/edit/mesh_tools.h"
#include "techniques/scene/box.h"

namespace sb {

glm::dmat4 lookFrom(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up) {
  const glm::dvec3 z = glm::normalize(eye - target);
  if (std::abs(glm::dot(z, glm::normalize(up))) > 0.9999) up = {0, 0, -1};
  const glm::dvec3 x = glm::normalize(glm::cross(up, z));
  const glm::dvec3 y = glm::cross(z, x);
  return glm::dmat4(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(eye, 1));
}

namespace {

/// Largest of x + k z, -x + k z, y + k z, -y + k z and z over the points seen from a camera's axes:
/// all that decides how near the camera can stand.
struct Extent {
  double right = -kInf, left = -kInf, up = -kInf, down = -kInf;
  double nearest = -kInf, farthest = kInf;  ///< z of the camera's axes, which look down -z
  static constexpr double kInf = std::numeric_limits<double>::infinity();

  void add(glm::dvec3 p, double k) {
    right = std::max(right, p.x + k * p.z), left = std::max(left, -p.x + k * p.z);
    up = std::max(up, p.y + k * p.z), down = std::max(down, -p.y + k * p.z);
    nearest = std::max(nearest, p.z), farthest = std::min(farthest, p.z);
  }
  bool empty() const { return right == -kInf; }
};

Extent extentOf(const Scene& scene, const glm::dmat3& toAxes, glm::dvec3 center, double k) {
  Extent extent;
  std::vector<uint8_t> used;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const glm::dmat3 linear = toAxes * glm::dmat3(instance.toWorld);
    const glm::dvec3 shift = toAxes * (glm::dvec3(instance.toWorld[3]) - center);
    used.assign(mesh.positions.size(), 0);
    for (const uint32_t i : mesh.indices)
      if (!used[i]) used[i] = 1, extent.add(linear * glm::dvec3(mesh.positions[i]) + shift, k);
  }
  for (const Medium& medium : scene.media) {
    const Box box = transformedBox(kMediumBox, medium.boxToWorld, center);
    for (int i = 0; i < 8; ++i) extent.add(toAxes * box.corner(i), k);
  }
  return extent;
}

}  // namespace

Camera framingCamera(const Scene& scene) {
  const Box box = sceneBox(scene);
  const glm::dvec3 center = box.empty() ? glm::dvec3(0) : box.center();
  const double radius = box.empty() || box.radius() == 0 ? 1.0 : box.radius();
  Camera camera;
  camera.name = "framing";
  camera.fovY = 0.8;
  camera.toWorld = lookFrom(glm::dvec3(0.5, 0.45, 1.0), glm::dvec3(0));
  const glm::dmat3 axes(camera.toWorld);
  const double k = 0.8 * std::tan(0.5 * camera.fovY);
  Extent extent = extentOf(scene, glm::transpose(axes), center, k);
  if (extent.empty()) extent.add(glm::dvec3(0), k);
  // The planes through the eye that bound 80 % of the picture touch the scene: two equations for
  // the sides, two for top and bottom; the pair that asks for more distance decides.
  double z = std::max(extent.right + extent.left, extent.up + extent.down) / (2 * k);
  z = std::max(z, extent.nearest + 0.01 * radius);
  const glm::dvec3 eye((extent.right - extent.left) / 2, (extent.up - extent.down) / 2, z);
  camera.toWorld[3] = glm::dvec4(center + axes * eye, 1);
  camera.farPlane = 1.1 * (z - extent.farthest) + 0.01 * radius;
  camera.nearPlane = std::max(0.9 * (z - extent.nearest), 1e-3 * camera.farPlane);
  if (extent.nearest == extent.farthest) camera.nearPlane *= 0.9;
  // Files may scale their scene to nothing; planes must be floats all the same.
  camera.nearPlane = std::max(camera.nearPlane, 1e-30);
  camera.farPlane = std::max(camera.farPlane, 1e-27);
  return camera;
}

void addDaylight(Scene& scene) {
  Light sun = defaultLight();
  sun.name = "sun";
  sun.intensity = 2.2f;  // 0.7 pi
  scene.lights = {sun};
  // What a file states itself stays.
  if (scene.sky == glm::vec3(0)) scene.sky = glm::vec3(0.2f);
}

void addGround(Scene& scene, double size) {
  const Box box = sceneBox(scene);
  const double radius = box.empty() || box.radius() == 0 ? 1.0 : box.radius();
  const glm::dvec3 low = box.empty() ? glm::dvec3(0) : box.low;
  const glm::dvec3 center = box.empty() ? glm::dvec3(0) : box.center();
  Material material;
  material.name = "ground";
  material.baseColor = {0.5f, 0.5f, 0.5f, 1};
  material.metallic = 0;
  material.doubleSided = true;
  Mesh mesh;
  mesh.name = "ground";
  mesh.material = uint32_t(scene.materials.size());
  mesh.positions = {{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};
  mesh.normals.assign(4, {0, 1, 0});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  numberTriangles(mesh);
  computeBounds(mesh);
  Instance instance{.name = "ground", .mesh = uint32_t(scene.meshes.size())};
  for (const Mesh& m : scene.meshes) mesh.key = std::max(mesh.key, m.key + 1);
  for (const Instance& i : scene.instances) instance.key = std::max(instance.key, i.key + 1);
  // Not in contact: what stands on the ground would share its plane.
  const double half = size * radius;
  instance.toWorld[0].x = instance.toWorld[2].z = half;
  instance.toWorld[3] = {center.x, low.y - 0.002 * radius, center.z, 1};
  scene.materials.push_back(material);
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(instance);
  for (Camera& camera : scene.cameras) {
    const double farthest =
        glm::length(glm::dvec3(instance.toWorld[3]) - camera.eye()) + 1.5 * half;
    if (camera.farPlane < farthest) camera.farPlane = farthest;
  }
}

Light defaultLight() {
  Light light;
  light.name = "default";
  light.direction = glm::normalize(glm::dvec3(0.45, -1.0, -0.5));
  light.intensity = 3.14159265f;
  return light;
}

}  // namespace sb
