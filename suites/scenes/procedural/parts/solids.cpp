#include "suites/scenes/procedural/parts/solids.h"

#include <array>
#include <cmath>
#include <span>

#include "suites/scenes/edit/world_path.h"
#include "suites/scenes/procedural/parts/random.h"
#include "techniques/scene/light_area.h"
#include "techniques/scene/placed_scene.h"

namespace sb {
namespace {

/// Appends a convex face, counter-clockwise.
void addFace(Mesh& mesh, std::span<const glm::vec3> corners) {
  const glm::vec3 normal =
      glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const uint32_t first = uint32_t(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  mesh.normals.insert(mesh.normals.end(), corners.size(), normal);
  for (uint32_t i = 2; i < corners.size(); ++i)
    mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
}

}  // namespace

Mesh cubeMesh(std::string name, uint32_t material, bool inward) {
  Mesh mesh;
  mesh.name = std::move(name);
  mesh.material = material;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 n(0), u(0), v(0);
      n[axis] = side, u[(axis + 1) % 3] = 1, v[(axis + 2) % 3] = inward ? -side : side;
      addFace(mesh, std::array{n - u - v, n + u - v, n + u + v, n - u + v});
    }
  return mesh;
}

Mesh columnMesh(std::string name, uint32_t material, uint32_t sides) {
  constexpr double kTwoPi = 6.283185307179586;
  Mesh mesh;
  mesh.name = std::move(name);
  mesh.material = material;
  std::vector<glm::vec3> top, bottom;
  for (uint32_t i = 0; i < sides; ++i) {
    const double angle = kTwoPi * i / sides;
    top.emplace_back(std::sin(angle), 1, std::cos(angle));
    bottom.emplace(bottom.begin(), std::sin(angle), -1, std::cos(angle));
  }
  addFace(mesh, top);
  addFace(mesh, bottom);
  const glm::vec3 down(0, -2, 0);
  for (uint32_t i = 0; i < sides; ++i) {
    const glm::vec3 a = top[i], b = top[(i + 1) % sides];
    addFace(mesh, std::array{a + down, b + down, b, a});
  }
  return mesh;
}

glm::dmat4 solidAt(const glm::dvec3& middle, const glm::dvec3& half, double turn) {
  const double c = std::cos(turn), s = std::sin(turn);
  return glm::dmat4(glm::dvec4(c, 0, -s, 0) * half.x, glm::dvec4(0, half.y, 0, 0),
                    glm::dvec4(s, 0, c, 0) * half.z, glm::dvec4(middle, 1));
}

void addLamp(Scene& scene, const glm::dvec3& position, double radius, double range,
             float intensity) {
  Light lamp = lampLight(position, {0, -1, 0}, LightShape::Point, 0);
  if (radius > 0) makeSphere(lamp, radius);
  lamp.color = {1.0f, 0.82f, 0.6f};
  lamp.intensity = intensity;
  lamp.range = range;
  scene.lights.push_back(lamp);
}

void circleOnGround(Scene& scene, std::string_view prefix, double share, double widest,
                    uint64_t seed, uint32_t steps) {
  const glm::dmat3 flat(glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0));
  Pcg random(seed, 2);
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    if (!scene.instances[i].name.starts_with(prefix)) continue;
    const bool moves = random.uniform() < share;
    const double radius = random.uniform(0.1, widest);
    if (moves) moveInstance(scene, i, circlePath(scene.instances[i].toWorld, flat, radius, steps));
  }
}

SceneParam lampRadiusParam(double fallback) {
  return {.name = "size",
          .unit = "world units",
          .fallback = fallback,
          .low = 0,
          .high = 0.5,
          .help = "radius of the lamps; 0 casts hard shadows"};
}

SceneParam movingShareParam(std::string what) {
  return {.name = "moving",
          .fallback = 0,
          .low = 0,
          .high = 1,
          .help = "share of the " + what +
                  " that go round circles, in a loop of frames (--motion steps=N)"};
}

SceneParam seedParam(std::string of) {
  return {.name = "seed",
          .fallback = 1,
          .low = 0,
          .high = 4294967295.0,
          .whole = true,
          .help = "of all " + of};
}

}  // namespace sb
