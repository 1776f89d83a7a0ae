// After the mine of the third source document (its screenshots and section 5.4): galleries
// in rock, side by side, with lamps of finite range, beams under their roofs and boxes along their
// walls, of which some go round. Only a small part of its lamps and boxes matters to any
// picture: what culls well draws little. Cost without culling grows with `lights` times `casters`.
#include <algorithm>
#include <cmath>

#include "suites/scenes/procedural/parts/random.h"
#include "suites/scenes/procedural/parts/solids.h"

namespace sb {
namespace {

// World units. Galleries run along z, and no lamp reaches a neighbour.
constexpr double kWidth = 4, kHeight = 3, kRun = 40, kSpacing = 14, kLampEvery = 4, kBeamEvery = 2;
constexpr double kRange = 7;

uint32_t runsFor(const ParamValues& p) {
  const double lamps = p.find("lights")->second;
  return uint32_t(std::max(1.0, std::ceil(lamps * kLampEvery / kRun)));
}

/// A place in the galleries: `along` all of them in turn, `aside` of the middle.
glm::dvec3 at(double along, double aside, double height) {
  const double run = std::floor(along / kRun);
  return {run * kSpacing + aside, height, -(along - run * kRun)};
}

void addRock(Scene& scene, uint32_t runs) {
  const uint32_t rock = addMaterial(scene, matteMaterial("rock", {0.45f, 0.38f, 0.32f}));
  const uint32_t room = addMesh(scene, cubeMesh("gallery", rock, true));
  for (uint32_t run = 0; run < runs; ++run) {
    const glm::dvec3 middle = at((run + 0.5) * kRun, 0, kHeight / 2);
    addInstance(scene, "gallery" + std::to_string(run), room,
                solidAt(middle, {kWidth / 2, kHeight / 2, kRun / 2}));
  }
}

void addBeams(Scene& scene, uint32_t mesh, uint32_t runs) {
  const uint32_t beams = uint32_t(runs * kRun / kBeamEvery);
  for (uint32_t i = 0; i < beams; ++i)
    addInstance(
        scene, "beam" + std::to_string(i), mesh,
        solidAt(at((i + 0.5) * kBeamEvery, 0, kHeight - 0.3), {kWidth / 2 - 0.05, 0.12, 0.12}));
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
                solidAt(at(along, aside, half.y), half, random.uniform(0, 1.5)));
  }
}

void addLamps(Scene& scene, const ParamValues& p, double length) {
  const uint32_t count = uint32_t(p.find("lights")->second);
  for (uint32_t i = 0; i < count; ++i)
    addLamp(scene, at((i + 0.5) * length / count, i % 2 ? 1.2 : -1.2, 2.2), p.find("size")->second,
            kRange, 5);
}

Scene make(const ParamValues& p) {
  Scene scene;
  const uint32_t runs = runsFor(p);
  const double length = runs * kRun;
  addRock(scene, runs);
  const uint32_t wood = addMaterial(scene, matteMaterial("wood", {0.5f, 0.33f, 0.18f}));
  const uint32_t cube = addMesh(scene, cubeMesh("box", wood));
  addBeams(scene, cube, runs);
  addBoxes(scene, cube, p, length);
  addLamps(scene, p, length);
  scene.ambient = glm::vec3(0.02f);
  addView(scene, {0.3, 1.6, -1.5}, {0, 1.3, -9}, 1.1, 0.2, kRun);
  return scene;
}

void move(Scene& scene, const ParamValues& p, uint32_t steps) {
  circleOnGround(scene, "box", p.find("moving")->second, 0.5, uint64_t(p.find("seed")->second),
                 steps);
}

}  // namespace

ProceduralScene mine() {
  return {{"mine",
           "galleries with many lamps, beams and boxes, most of them out of sight",
           {countParam("lights", 10, 1, 1000, "how many lamps; ten to a gallery"),
            countParam("casters", 40, 0, 20000, "how many boxes"), lampRadiusParam(0.08),
            movingShareParam("boxes"), seedParam("boxes")}},
          make,
          move};
}

}  // namespace sb
