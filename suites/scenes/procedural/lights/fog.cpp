// Light shafts: a sun falls aslant through the slots of a blind into a medium; a sphere in it
// throws its shadow through medium and room. The medium is even fog, a column of smoke or a grid.
#include <algorithm>
#include <cmath>

#include "suites/scenes/edit/framing.h"
#include "suites/scenes/procedural/scenes.h"

namespace sb {
namespace {

/// A ball that thins out toward its rim.
void fillGrid(Medium& medium) {
  medium.size = glm::uvec3(16);
  for (uint32_t z = 0; z < 16; ++z)
    for (uint32_t y = 0; y < 16; ++y)
      for (uint32_t x = 0; x < 16; ++x) {
        const glm::vec3 at = (glm::vec3(x, y, z) + 0.5f) / 8.0f - 1.0f;
        medium.density.push_back(std::max(0.0f, 1.0f - glm::dot(at, at)));
      }
}

Medium mediumOf(const ParamValues& p) {
  Medium medium{.name = "medium",
                .kind = MediumKind(p.find("medium")->second),
                .extinction = glm::vec3(float(p.find("extinction")->second)),
                .albedo = glm::vec3(float(p.find("albedo")->second)),
                .anisotropy = float(p.find("anisotropy")->second),
                .time = p.find("time")->second};
  // Fog fills the room; smoke and ball stand in it.
  const bool fills = medium.kind == MediumKind::Homogeneous;
  const glm::dvec3 low = fills ? glm::dvec3(-4, 0, -4) : glm::dvec3(-2, 0, -2);
  const glm::dvec3 high = fills ? glm::dvec3(4, 4, 2) : glm::dvec3(2, 4, 2);
  for (int axis = 0; axis < 3; ++axis) medium.boxToWorld[axis] *= high[axis] - low[axis];
  medium.boxToWorld[3] = glm::dvec4(low, 1);
  if (medium.kind == MediumKind::Grid) fillGrid(medium);
  return medium;
}

Scene make(const ParamValues& p) {
  Scene scene;
  const uint32_t grey = addMaterial(scene, matteMaterial("grey", glm::vec3(0.5f)));
  const uint32_t red = addMaterial(scene, matteMaterial("red", {0.7f, 0.15f, 0.1f}));
  const auto at = [](glm::dvec3 place, double size = 1) {
    glm::dmat4 m(size);
    m[3] = glm::dvec4(place, 1);
    return m;
  };
  const glm::dvec3 floor(0, 0, -1);
  addInstance(scene, "floor", addMesh(scene, quadMesh("floor", grey, {4, 3})),
              lookFrom(floor, floor - glm::dvec3(0, 1, 0), {0, 0, -1}));
  addInstance(scene, "wall", addMesh(scene, quadMesh("wall", grey, {4, 2})), at({0, 2, -4}));
  addInstance(scene, "ball", addMesh(scene, sphereMesh("ball", red, 24)), at({-1, 1.4, 0}, 0.4));
  // Slats across the left side leave three slots under a board; light comes over that as well.
  const auto close = [&](const char* name, uint32_t mesh, double height) {
    const glm::dvec3 place(-4, height, -1);
    addInstance(scene, name, mesh, lookFrom(place, place - glm::dvec3(1, 0, 0)));
  };
  const uint32_t slat = addMesh(scene, quadMesh("slat", grey, {3, 0.25f}));
  for (int i = 0; i < 3; ++i) close("slat", slat, 0.55 + i);
  close("board", addMesh(scene, quadMesh("board", grey, {3, 0.8f})), 4.1);
  scene.lights.push_back(sunLight({1, -0.55, -0.12}, glm::radians(p.find("sun")->second)));
  scene.ambient = glm::vec3(0.03f);
  addView(scene, {0.8, 2.6, 9}, {0, 1.5, -1}, 0.7, 1, 30);
  scene.media.push_back(mediumOf(p));
  return scene;
}

}  // namespace

ProceduralScene fog() {
  return {{"fog",
           "sunlight through a blind into fog, smoke or a grid of densities, a ball's shadow in it",
           {{.name = "medium",
             .choices = {"homogeneous", "smoke", "grid"},
             .help = "what fills the room or stands in it"},
            {.name = "extinction",
             .unit = "per unit of length",
             .fallback = 0.3,
             .low = 0,
             .high = 1e6,
             .help = "what density 1 takes from light"},
            {.name = "albedo",
             .fallback = 0.9,
             .low = 0,
             .high = 1,
             .help = "share of it that is scattered"},
            {.name = "anisotropy",
             .fallback = 0,
             .low = -0.99,
             .high = 0.99,
             .help = "Henyey-Greenstein's g: above 0 scatters straight on"},
            {.name = "time",
             .unit = "s",
             .fallback = 0,
             .low = 0,
             .high = 1e6,
             .help = "how long the smoke has been rising"},
            sunRadiusParam()}},
          make};
}

}  // namespace sb
