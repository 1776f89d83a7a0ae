// After the mine of the third source document (its screenshots and section 5.4): galleries
// in rock, side by side, with lamps of finite range, beams under their roofs and boxes along their
// walls, of which some go round. Only a small part of its lamps and boxes matters to any
// picture: what culls well draws little. Cost without culling grows with `lights` times `casters`.
#include <algorithm>
#include <array>
#include <cmath>

#include "suites/scenes/edit/framing.h"
#include "suites/scenes/edit/mesh_tools.h"
#include "suites/scenes/edit/world_path.h"
#include "suites/scenes/procedural/random.h"
#include "suites/scenes/procedural/scenes.h"
#include "techniques/scene/light_area.h"
#include "techniques/scene/placed_scene.h"

namespace sb {
namespace {

// World units. Galleries run along z, and no lamp reaches a neighbour.
constexpr double kWidth = 4, kHeight = 3, kRun = 40, kSpacing = 14, kLampEvery = 4, kBeamEvery = 2;
constexpr double kRange = 7, kLampRadius = 0.08;

uint32_t runsFor(const ParamValues& p) {
  const double lamps = p.find("lights")->second;
  return uint32_t(std::max(1.0, std::ceil(lamps * kLampEvery / kRun)));
}

/// A place in the galleries: `along` all of them in turn, `aside` of the middle.
glm::dvec3 at(double along, double aside, double height) {
  const double run = std::floor(along / kRun);
  return {run * kSpacing + aside, height, -(along - run * kRun)};
}

glm::dmat4 boxAt(const glm::dvec3& middle, const glm::dvec3& half, double turn = 0) {
  const glm::dmat3 turned(std::cos(turn), 0, -std::sin(turn), 0, 1, 0, std::sin(turn), 0,
                          std::cos(turn));
  glm::dmat4 m(turned * glm::dmat3(half.x, 0, 0, 0, half.y, 0, 0, 0, half.z));
  m[3] = glm::dvec4(middle, 1);
  return m;
}

/// From -1 to 1, normals outward or, of a room, inward.
Mesh cubeMesh(std::string name, uint32_t material, bool inward) {
  Mesh mesh;
  mesh.name = std::move(name);
  mesh.material = material;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 n(0), u(0), v(0);
      n[axis] = side, u[(axis + 1) % 3] = 1, v[(axis + 2) % 3] = side;
      const uint32_t first = uint32_t(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), {n - u - v, n + u - v, n + u + v, n - u + v});
      mesh.normals.insert(mesh.normals.end(), 4, inward ? -n : n);
      const std::array<uint32_t, 6> outward = {0, 1, 2, 0, 2, 3}, turned = {0, 2, 1, 0, 3, 2};
      for (const uint32_t i : inward ? turned : outward) mesh.indices.push_back(first + i);
    }
  return mesh;
}

void addRock(Scene& scene, uint32_t runs) {
  const uint32_t rock = addMaterial(scene, matteMaterial("rock", {0.45f, 0.38f, 0.32f}));
  const uint32_t room = addMesh(scene, cubeMesh("gallery", rock, true));
  for (uint32_t run = 0; run < runs; ++run) {
    const glm::dvec3 middle = at((run + 0.5) * kRun, 0, kHeight / 2);
    addInstance(scene, "gallery" + std::to_string(run), room,
                boxAt(middle, {kWidth / 2, kHeight / 2, kRun / 2}));
  }
}

void addBeams(Scene& scene, uint32_t mesh, uint32_t runs) {
  const uint32_t beams = uint32_t(runs * kRun / kBeamEvery);
  for (uint32_t i = 0; i < beams; ++i)
    addInstance(
        scene, "beam" + std::to_string(i), mesh,
        boxAt(at((i + 0.5) * kBeamEvery, 0, kHeight - 0.3), {kWidth / 2 - 0.05, 0.12, 0.12}));
}

void addBoxes(Scene& scene, uint32_t mesh, const ParamValues& p, double length) {
  Pcg random(uint64_t(p.find("seed")->second), 1);
  const uint32_t count = uint32_t(p.find("casters")->second);
  for (uint32_t i = 0; i < count; ++i) {
    const double along = (i + random.uniform()) * length / count;
    const double aside = (random.below(2) ? 1 : -1) * random.uniform(0.7, 1.4);
    const glm::dvec3 half(random.uniform(0.15, 0.35), random.uniform(0.15, 0.4),
                          random.uniform(0.15, 0.35));
    addInstance(scene, "box" + std::to_string(i), mesh,
                boxAt(at(along, aside, half.y), half, random.uniform(0, 1.5)));
  }
}

void addLamps(Scene& scene, const ParamValues& p, double length) {
  const uint32_t count = uint32_t(p.find("lights")->second);
  for (uint32_t i = 0; i < count; ++i) {
    const double along = (i + 0.5) * length / count;
    Light lamp = lampLight(at(along, i % 2 ? 1.2 : -1.2, 2.2), {0, -1, 0}, LightShape::Point, 0);
    if (p.find("size")->second > 0) makeSphere(lamp, p.find("size")->second);
    lamp.color = {1.0f, 0.82f, 0.6f};
    lamp.intensity = 5;
    lamp.range = kRange;
    scene.lights.push_back(lamp);
  }
}

Scene make(const ParamValues& p) {
  Scene scene;
  const uint32_t runs = runsFor(p);
  const double length = runs * kRun;
  addRock(scene, runs);
  const uint32_t wood = addMaterial(scene, matteMaterial("wood", {0.5f, 0.33f, 0.18f}));
  const uint32_t cube = addMesh(scene, cubeMesh("box", wood, false));
  addBeams(scene, cube, runs);
  addBoxes(scene, cube, p, length);
  addLamps(scene, p, length);
  scene.ambient = glm::vec3(0.02f);
  Camera camera;
  camera.name = "view";
  camera.fovY = 1.1;
  camera.toWorld = lookFrom({0.3, 1.6, -1.5}, {0, 1.3, -9});
  camera.nearPlane = 0.2;
  camera.farPlane = kRun;
  scene.cameras.push_back(camera);
  return scene;
}

// Boxes of a share, drawn without their order mattering, go round circles on the ground.
void move(Scene& scene, const ParamValues& p, uint32_t steps) {
  Pcg random(uint64_t(p.find("seed")->second), 2);
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    if (!scene.instances[i].name.starts_with("box")) continue;
    const bool moves = random.uniform() < p.find("moving")->second;
    const glm::dmat3 flat(glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0));
    const double radius = random.uniform(0.1, 0.5);
    if (moves) moveInstance(scene, i, circlePath(scene.instances[i].toWorld, flat, radius, steps));
  }
}

}  // namespace

ProceduralScene mine() {
  return {{"mine",
           "galleries with many lamps, beams and boxes, most of them out of sight",
           {{.name = "lights",
             .fallback = 10,
             .low = 1,
             .high = 1000,
             .whole = true,
             .help = "how many lamps; ten to a gallery"},
            {.name = "casters",
             .fallback = 40,
             .low = 0,
             .high = 20000,
             .whole = true,
             .help = "how many boxes"},
            {.name = "size",
             .unit = "world units",
             .fallback = kLampRadius,
             .low = 0,
             .high = 0.5,
             .help = "radius of the lamps; 0 casts hard shadows"},
            {.name = "moving",
             .fallback = 0,
             .low = 0,
             .high = 1,
             .help = "share of the boxes that go round circles, in a loop of frames "
                     "(--motion steps=N)"},
            {.name = "seed",
             .fallback = 1,
             .low = 0,
             .high = 4294967295.0,
             .whole = true,
             .help = "of all boxes"}}},
          make,
          move};
}

}  // namespace sb
