#include "suites/scenes/procedural/parts/shapes.h"

#include "suites/scenes/edit/framing.h"
#include "suites/scenes/edit/mesh_tools.h"

namespace sb {

Material matte(glm::vec3 color) {
  Material m;
  m.baseColor = glm::vec4(color, 1);
  m.metallic = 0;
  m.roughness = 1;
  m.doubleSided = true;
  return m;
}

Material glass(float alpha, glm::vec3 t) {
  Material m = matte();
  m.opticsOverride = true;
  m.overrideAlpha = alpha;
  m.overrideTransmission = t;
  return m;
}

uint32_t add(Scene& scene, Material material) {
  scene.materials.push_back(std::move(material));
  return uint32_t(scene.materials.size() - 1);
}

uint32_t add(Scene& scene, Mesh mesh) {
  numberTriangles(mesh);
  computeBounds(mesh);
  mesh.key = uint32_t(scene.meshes.size());
  scene.meshes.push_back(std::move(mesh));
  return scene.meshes.back().key;
}

uint32_t place(Scene& scene, uint32_t mesh, const glm::dmat4& toWorld) {
  const uint32_t index = uint32_t(scene.instances.size());
  scene.instances.push_back({.name = "instance " + std::to_string(index),
                             .mesh = mesh,
                             .toWorld = toWorld,
                             .key = index});
  return index;
}

Mesh quadMesh(uint32_t material, glm::vec3 center, glm::vec3 u, glm::vec3 v) {
  Mesh mesh;
  mesh.material = material;
  mesh.positions = {center - u - v, center + u - v, center + u + v, center - u + v};
  mesh.normals.assign(4, glm::normalize(glm::cross(u, v)));
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

uint32_t addQuad(Scene& scene, uint32_t material, glm::vec3 center, glm::vec3 u, glm::vec3 v) {
  return place(scene, add(scene, quadMesh(material, center, u, v)));
}

uint32_t addHorizontal(Scene& scene, uint32_t material, glm::vec3 center, float halfX,
                       float halfZ) {
  return addQuad(scene, material, center, {0, 0, halfZ}, {halfX, 0, 0});
}

uint32_t addBox(Scene& scene, uint32_t material, glm::vec3 low, glm::vec3 high) {
  const glm::vec3 center = (low + high) * 0.5f, half = (high - low) * 0.5f;
  Mesh box;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {1.0f, -1.0f}) {
      glm::vec3 n(0), u(0), v(0);
      n[axis] = side * half[axis];
      u[(axis + 1) % 3] = half[(axis + 1) % 3];
      v[(axis + 2) % 3] = side * half[(axis + 2) % 3];
      const Mesh quad = quadMesh(material, center + n, u, v);
      const uint32_t base = uint32_t(box.positions.size());
      box.positions.insert(box.positions.end(), quad.positions.begin(), quad.positions.end());
      box.normals.insert(box.normals.end(), quad.normals.begin(), quad.normals.end());
      for (const uint32_t i : quad.indices) box.indices.push_back(base + i);
    }
  box.material = material;
  return place(scene, add(scene, std::move(box)));
}

glm::dmat4 translation(glm::dvec3 offset) {
  glm::dmat4 m(1);
  m[3] = glm::dvec4(offset, 1);
  return m;
}

Light sun(glm::dvec3 direction) {
  Light light;
  light.direction = glm::normalize(direction);
  light.intensity = 3.14159265f;
  return light;
}

Light pointLight(glm::dvec3 position, float intensity) {
  Light light;
  light.type = LightType::Point;
  light.position = position;
  light.intensity = intensity;
  return light;
}

Light spotLight(glm::dvec3 position, glm::dvec3 direction, double outerCone, float intensity) {
  Light light = pointLight(position, intensity);
  light.type = LightType::Spot;
  light.direction = glm::normalize(direction);
  light.outerCone = outerCone;
  light.innerCone = outerCone / 2;
  return light;
}

void addLight(Scene& scene, Light light) {
  light.key = uint32_t(scene.lights.size());
  scene.lights.push_back(std::move(light));
}

Camera downCamera(glm::dvec3 eye, double halfHeight, double farPlane) {
  Camera camera;
  camera.toWorld = lookFrom(eye, eye - glm::dvec3(0, 1, 0), {0, 0, -1});
  camera.orthographic = true;
  camera.halfHeight = halfHeight;
  camera.nearPlane = 1.0 / 64;
  camera.farPlane = farPlane;
  return camera;
}

Camera lookAt(glm::dvec3 eye, glm::dvec3 target, double fovY, double farPlane) {
  Camera camera;
  camera.toWorld = lookFrom(eye, target);
  camera.fovY = fovY;
  camera.nearPlane = 1.0 / 16;
  camera.farPlane = farPlane;
  return camera;
}

Scene floorScene(bool light) {
  Scene scene;
  scene.name = "floor";
  addHorizontal(scene, add(scene, matte()), {0, 0, 0}, 4, 4);
  scene.cameras.push_back(downCamera({0, 0.5, 0}, 4, 8));
  if (light) addLight(scene, sun({0, -1, 0}));
  return scene;
}

}  // namespace sb
