// After figure B.3 of the third source document: a library by lamplight. Shelves of books, of
// which some stick out or lean, tables and columns: many thin casters side by side, whose shadows
// overlap from every lamp.
#include <cmath>

#include "suites/scenes/procedural/parts/random.h"
#include "suites/scenes/procedural/parts/solids.h"

namespace sb {
namespace {

// World units: metres. The room is closed; the camera stands within it.
constexpr glm::dvec3 kRoom(5, 1.8, 4);
constexpr double kShelfHalf = 1.2, kShelfDepth = 0.18, kBoardHeight = 0.42;
constexpr int kBoards = 4;

struct Meshes {
  uint32_t wood, leather[3], stone;
};

Meshes addMeshes(Scene& scene) {
  const auto matte = [&](const char* name, glm::vec3 colour) {
    return addMaterial(scene, matteMaterial(name, colour));
  };
  const uint32_t plaster = matte("plaster", {0.6f, 0.55f, 0.45f});
  addInstance(scene, "room", addMesh(scene, cubeMesh("room", plaster, true)),
              solidAt({0, kRoom.y, 0}, kRoom));
  const auto cube = [&](const char* name, glm::vec3 colour) {
    return addMesh(scene, cubeMesh(name, matte(name, colour)));
  };
  return {.wood = cube("wood", {0.35f, 0.2f, 0.1f}),
          .leather = {cube("red", {0.45f, 0.08f, 0.06f}), cube("green", {0.1f, 0.28f, 0.12f}),
                      cube("brown", {0.4f, 0.26f, 0.12f})},
          .stone = addMesh(scene, columnMesh("stone", matte("stone", {0.55f, 0.55f, 0.52f}), 12))};
}

/// With its back at z = `back`, facing +z.
void addShelf(Scene& scene, const Meshes& m, double x, double back, uint32_t books, Pcg& random) {
  const double z = back + kShelfDepth;
  for (const double side : {-kShelfHalf, kShelfHalf})
    addInstance(scene, "side", m.wood,
                solidAt({x + side, kBoards * kBoardHeight / 2, z},
                        {0.03, kBoards * kBoardHeight / 2, kShelfDepth}));
  for (int board = 0; board <= kBoards; ++board) {
    const double floor = board * kBoardHeight + 0.02;
    addInstance(scene, "board", m.wood, solidAt({x, floor, z}, {kShelfHalf, 0.02, kShelfDepth}));
    if (board == kBoards) break;
    const double width = 2 * (kShelfHalf - 0.05) / books;
    for (uint32_t i = 0; i < books; ++i) {
      const double height = random.uniform(0.11, 0.17), depth = random.uniform(0.6, 1.05);
      const bool missing = random.below(6) == 0;
      const uint32_t cover = m.leather[random.below(3)];
      if (missing) continue;
      addInstance(scene, "book" + std::to_string(scene.instances.size()), cover,
                  solidAt({x - kShelfHalf + 0.05 + (i + 0.5) * width, floor + 0.021 + height, z},
                          {0.45 * width, height, kShelfDepth * depth}));
    }
  }
}

void addTable(Scene& scene, const Meshes& m, double x, double z) {
  addInstance(scene, "table", m.wood, solidAt({x, 0.76, z}, {0.8, 0.03, 0.5}));
  for (const double dx : {-0.7, 0.7})
    for (const double dz : {-0.4, 0.4})
      addInstance(scene, "leg", m.wood, solidAt({x + dx, 0.365, z + dz}, {0.04, 0.365, 0.04}));
}

Scene make(const ParamValues& p) {
  Scene scene;
  const Meshes m = addMeshes(scene);
  Pcg random(uint64_t(p.find("seed")->second), 1);
  const uint32_t books = uint32_t(p.find("books")->second);
  for (const double x : {-2.8, 0.0, 2.8}) addShelf(scene, m, x, -kRoom.z + 0.01, books, random);
  // One stands free, and is seen from its side.
  addShelf(scene, m, -2.9, -1.4, books, random);
  for (const double x : {-1.2, 3.4})
    addInstance(scene, "column", m.stone, solidAt({x, kRoom.y, -0.6}, {0.2, kRoom.y, 0.2}));
  addTable(scene, m, 1.2, 0.4);
  for (int i = 0; i < 3; ++i)
    addInstance(scene, "book on the table", m.leather[i],
                solidAt({1.0 + 0.3 * i, 0.83, 0.3 + 0.1 * i}, {0.1, 0.04, 0.14}, 0.4 * i));
  const double radius = p.find("size")->second;
  constexpr glm::dvec3 kLamps[] = {
      {1.3, 2.6, 0.2}, {-3.6, 2.8, 0.8}, {3.8, 2.4, -2.2}, {-0.6, 3, -2}};
  for (size_t i = 0; i < size_t(p.find("lights")->second); ++i)
    addLamp(scene, kLamps[i], radius, 9, 13);
  scene.ambient = glm::vec3(0.03f);
  addView(scene, {0.6, 1.9, 3.7}, {0, 1.0, -1.5}, 0.95, 0.3, 14);
  return scene;
}

void move(Scene& scene, const ParamValues& p, uint32_t steps) {
  circleOnGround(scene, "book", p.find("moving")->second, 0.15, uint64_t(p.find("seed")->second),
                 steps);
}

}  // namespace

ProceduralScene library() {
  return {{"library",
           "shelves of books, a table and columns by lamplight",
           {countParam("lights", 2, 1, 4, "how many lamps"),
            countParam("books", 12, 1, 60, "places for books on a board; there are 16 boards"),
            lampRadiusParam(0.1), movingShareParam("books"), seedParam("books")}},
          make,
          move};
}

}  // namespace sb
