#include <cmath>

#include "suites/scenes/edit/framing.h"
#include "suites/scenes/edit/mesh_tools.h"
#include "suites/scenes/procedural/scenes.h"
#include "techniques/scene/light_area.h"
#include "techniques/scene/light_data.h"

namespace sb {

uint32_t addMesh(Scene& scene, Mesh mesh) {
  mesh.key = uint32_t(scene.meshes.size());
  numberTriangles(mesh);
  computeBounds(mesh);
  scene.meshes.push_back(std::move(mesh));
  return scene.meshes.back().key;
}

uint32_t addInstance(Scene& scene, std::string name, uint32_t mesh, const glm::dmat4& toWorld) {
  const uint32_t key = uint32_t(scene.instances.size());
  scene.instances.push_back({std::move(name), mesh, toWorld, key});
  return key;
}

uint32_t addMaterial(Scene& scene, Material material) {
  scene.materials.push_back(std::move(material));
  return uint32_t(scene.materials.size() - 1);
}

Mesh quadMesh(std::string name, uint32_t material, glm::vec2 half) {
  Mesh mesh;
  mesh.name = std::move(name);
  mesh.material = material;
  mesh.positions = {
      {-half.x, -half.y, 0}, {half.x, -half.y, 0}, {half.x, half.y, 0}, {-half.x, half.y, 0}};
  mesh.normals.assign(4, glm::vec3(0, 0, 1));
  mesh.uv0 = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

Mesh sphereMesh(std::string name, uint32_t material, uint32_t rings) {
  constexpr double kPi = 3.14159265358979323846;
  const uint32_t segments = 2 * rings;
  Mesh mesh;
  mesh.name = std::move(name);
  mesh.material = material;
  mesh.positions.push_back({0, 1, 0});
  for (uint32_t r = 1; r < rings; ++r)
    for (uint32_t s = 0; s < segments; ++s) {
      const double polar = kPi * r / rings, turn = 2 * kPi * s / segments;
      mesh.positions.push_back(glm::vec3(glm::dvec3(
          std::sin(polar) * std::sin(turn), std::cos(polar), std::sin(polar) * std::cos(turn))));
    }
  mesh.positions.push_back({0, -1, 0});
  mesh.normals = mesh.positions;
  const auto at = [&](uint32_t ring, uint32_t s) {
    return 1 + (ring - 1) * segments + s % segments;
  };
  const uint32_t south = uint32_t(mesh.positions.size() - 1);
  for (uint32_t s = 0; s < segments; ++s) {
    mesh.indices.insert(mesh.indices.end(), {0, at(1, s), at(1, s + 1)});
    for (uint32_t r = 1; r + 1 < rings; ++r)
      mesh.indices.insert(mesh.indices.end(), {at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s),
                                               at(r + 1, s + 1), at(r, s + 1)});
    mesh.indices.insert(mesh.indices.end(), {at(rings - 1, s), south, at(rings - 1, s + 1)});
  }
  return mesh;
}

Light sunLight(glm::dvec3 direction, double angularRadius) {
  Light light;
  light.name = "sun";
  light.direction = glm::normalize(direction);
  light.intensity = 3.14159265f;
  light.angularRadius = angularRadius;
  return light;
}

Material matteMaterial(std::string name, glm::vec3 colour) {
  Material m;
  m.name = std::move(name);
  m.baseColor = glm::vec4(colour, 1);
  m.metallic = 0;
  m.roughness = 1;
  return m;
}

Material paneMaterial(std::string name, glm::vec3 colour, float alpha) {
  Material m = matteMaterial(std::move(name), colour);
  m.baseColor.a = alpha;
  m.alphaMode = AlphaMode::Blend;
  m.doubleSided = true;
  return m;
}

void addView(Scene& scene, glm::dvec3 eye, glm::dvec3 target, double fovY, double nearPlane,
             double farPlane) {
  Camera camera;
  camera.name = "view";
  camera.toWorld = lookFrom(eye, target);
  camera.fovY = fovY;
  camera.nearPlane = nearPlane;
  camera.farPlane = farPlane;
  scene.cameras.push_back(camera);
}

SceneParam countParam(std::string name, double fallback, double low, double high,
                      std::string help) {
  return {.name = std::move(name),
          .fallback = fallback,
          .low = low,
          .high = high,
          .whole = true,
          .help = std::move(help)};
}

SceneParam circlingParam() {
  return {.name = "circling",
          .unit = "degrees",
          .fallback = 0,
          .low = 0,
          .high = 360,
          .help = "how far the lights go round the scene in a loop of frames (--motion steps=N)"};
}

SceneParam sunRadiusParam() {
  return {.name = "sun",
          .unit = "degrees",
          .fallback = 0,
          .low = 0,
          .high = 10,
          .help = "angular radius of the light; 0 casts hard shadows"};
}

std::vector<SceneParam> withLight(std::vector<SceneParam> params) {
  params.push_back(sunRadiusParam());
  params.push_back({.name = "light",
                    .choices = {"sun", "ellipsoid", "rectangle", "disc", "sphere"},
                    .help = "the sun, or a lamp of that shape"});
  params.push_back({.name = "lamp",
                    .unit = "world units",
                    .fallback = 1,
                    .low = 0.001,
                    .high = 5,
                    .help = "largest half axis of the lamp"});
  return params;
}

Light chosenLight(const ParamValues& p, glm::dvec3 direction, glm::dvec3 target, double distance) {
  const double choice = p.find("light")->second;
  if (choice == 0) return sunLight(direction, glm::radians(p.find("sun")->second));
  const glm::dvec3 along = glm::normalize(direction);
  const double size = p.find("lamp")->second;
  const bool sphere = choice == 4;
  Light light = lampLight(target - distance * along, along,
                          sphere ? LightShape::Point : LightShape(choice), size);
  if (sphere) makeSphere(light, size);
  light.intensity = float(3.14159265 * distance * distance);
  return light;
}

Light lampLight(glm::dvec3 position, glm::dvec3 direction, LightShape shape, double size) {
  Light light;
  light.name = "lamp";
  light.type = LightType::Point;
  light.position = position;
  light.direction = glm::normalize(direction);
  light.shape = shape;
  if (shape == LightShape::Point) return light;
  const glm::dmat3 axes = glm::transpose(lightAxes(light.direction));
  const glm::dvec3 lengths =
      shape == LightShape::Ellipsoid ? glm::dvec3(1, 2.0 / 3, 1.0 / 3) : glm::dvec3(1, 0.5, 0);
  for (int i = 0; i < 3; ++i) light.halfAxes[i] = axes[i] * (lengths[i] * size);
  return light;
}

}  // namespace sb
