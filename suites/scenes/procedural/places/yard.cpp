// After figure B.1 of the third source document: a back yard between walls, with a fence, a tree, a
// bench, barrels and boxes, under a few lamps. Shadows of many sizes overlap, and posts and
// branches are narrower than their penumbrae.
#include <cmath>

#include "suites/scenes/procedural/parts/random.h"
#include "suites/scenes/procedural/parts/solids.h"

namespace sb {
namespace {

// World units: metres. The yard is open toward +z, where the camera stands.
constexpr double kHalf = 6, kWall = 4;

struct Materials {
  uint32_t ground, brick, wood, iron, leaves;
};

Materials addMaterials(Scene& scene) {
  const auto matte = [&](const char* name, glm::vec3 colour) {
    return addMaterial(scene, matteMaterial(name, colour));
  };
  return {matte("ground", {0.42f, 0.4f, 0.36f}), matte("brick", {0.5f, 0.24f, 0.17f}),
          matte("wood", {0.45f, 0.3f, 0.17f}), matte("iron", {0.2f, 0.2f, 0.22f}),
          matte("leaves", {0.16f, 0.34f, 0.1f})};
}

void addWalls(Scene& scene, const Materials& m) {
  addInstance(scene, "ground", addMesh(scene, cubeMesh("ground", m.ground)),
              solidAt({0, -0.1, 0}, {kHalf + 0.3, 0.1, kHalf + 0.3}));
  const uint32_t wall = addMesh(scene, cubeMesh("wall", m.brick));
  addInstance(scene, "back", wall, solidAt({0, kWall / 2, -kHalf}, {kHalf, kWall / 2, 0.2}));
  addInstance(scene, "left", wall, solidAt({-kHalf, kWall / 2, 0}, {0.2, kWall / 2, kHalf}));
  addInstance(scene, "pillar", wall, solidAt({-kHalf + 1.2, 0.9, -kHalf + 1}, {0.3, 0.9, 0.3}));
}

/// Along the right side.
void addFence(Scene& scene, const Materials& m) {
  const uint32_t board = addMesh(scene, cubeMesh("board", m.wood));
  for (int i = 0; i < 24; ++i)
    addInstance(scene, "board" + std::to_string(i), board,
                solidAt({kHalf, 0.8, -kHalf + 0.5 * i + 0.25}, {0.03, 0.8, 0.15}));
  for (const double height : {0.4, 1.2})
    addInstance(scene, "rail", board, solidAt({kHalf - 0.06, height, 0}, {0.03, 0.06, kHalf}));
}

void addTree(Scene& scene, const Materials& m, Pcg& random) {
  const glm::dvec3 foot(2.6, 0, -2.8);
  const uint32_t trunk = addMesh(scene, columnMesh("trunk", m.wood, 9));
  addInstance(scene, "trunk", trunk, solidAt(foot + glm::dvec3(0, 1.2, 0), {0.18, 1.2, 0.18}));
  const uint32_t crown = addMesh(scene, sphereMesh("crown", m.leaves, 6));
  for (int i = 0; i < 7; ++i) {
    const double x = random.uniform(-0.8, 0.8), y = random.uniform(2.2, 3.4);
    const double z = random.uniform(-0.8, 0.8), radius = random.uniform(0.3, 0.6);
    addInstance(scene, "crown" + std::to_string(i), crown,
                solidAt(foot + glm::dvec3(x, y, z), glm::dvec3(radius)));
  }
}

void addBench(Scene& scene, const Materials& m) {
  const uint32_t plank = addMesh(scene, cubeMesh("plank", m.wood));
  const uint32_t leg = addMesh(scene, cubeMesh("leg", m.iron));
  for (int i = 0; i < 3; ++i) {
    addInstance(scene, "seat", plank, solidAt({-4.9 + 0.16 * i, 0.5, 0.5}, {0.06, 0.03, 1}));
    addInstance(scene, "back", plank, solidAt({-5.15, 0.75 + 0.16 * i, 0.5}, {0.03, 0.06, 1}));
  }
  for (const double z : {-0.3, 1.3})
    addInstance(scene, "leg", leg, solidAt({-4.95, 0.25, z}, {0.25, 0.22, 0.04}));
}

void addClutter(Scene& scene, const Materials& m, const ParamValues& p) {
  const uint32_t barrel = addMesh(scene, columnMesh("barrel", m.iron, 12));
  const uint32_t box = addMesh(scene, cubeMesh("box", m.wood));
  Pcg random(uint64_t(p.find("seed")->second), 1);
  addTree(scene, m, random);
  const uint32_t count = uint32_t(p.find("casters")->second);
  for (uint32_t i = 0; i < count; ++i) {
    const double x = random.uniform(-3.6, 4.6), z = random.uniform(-4.6, 3.2);
    const double half = random.uniform(0.15, 0.4), turn = random.uniform(0, 1.5);
    const bool round = random.below(3) == 0;
    addInstance(
        scene, "thing" + std::to_string(i), round ? barrel : box,
        solidAt({x, half, z}, glm::dvec3(round ? 0.7 * half : half, half, 0.7 * half), turn));
  }
}

Scene make(const ParamValues& p) {
  Scene scene;
  const Materials m = addMaterials(scene);
  addWalls(scene, m);
  addFence(scene, m);
  addBench(scene, m);
  addClutter(scene, m, p);
  const double radius = p.find("size")->second;
  constexpr glm::dvec3 kLamps[] = {
      {-2.5, 3.4, -5.2}, {4.6, 2.8, 2.4}, {-4.8, 2.6, 3.6}, {0.4, 4.5, 0}};
  const size_t lights = size_t(p.find("lights")->second);
  for (size_t i = 0; i < lights; ++i) addLamp(scene, kLamps[i], radius, 14, 26);
  scene.ambient = glm::vec3(0.015f, 0.02f, 0.035f);
  scene.background = glm::vec3(0.01f, 0.015f, 0.03f);
  addView(scene, {1.5, 5.2, 10.5}, {-0.2, 0.8, -0.8}, 0.85, 1, 30);
  return scene;
}

void move(Scene& scene, const ParamValues& p, uint32_t steps) {
  circleOnGround(scene, "thing", p.find("moving")->second, 0.8, uint64_t(p.find("seed")->second),
                 steps);
}

}  // namespace

ProceduralScene yard() {
  return {{"yard",
           "a back yard with a fence, a tree and clutter under lamps",
           {countParam("lights", 2, 1, 4, "how many lamps"),
            countParam("casters", 16, 0, 400, "how many boxes and barrels"), lampRadiusParam(0.15),
            movingShareParam("boxes and barrels"), seedParam("boxes and barrels")}},
          make,
          move};
}

}  // namespace sb
