// Modisett 2023, section 5.1: 1000 opaque grey spheres at random places, and 0..2000 blue
// translucent quads in a region that overlaps theirs and reaches further toward one white
// directional light. Cost grows with `quads`; the spheres are the same for every count.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "suites/scenes/edit/framing.h"
#include "suites/scenes/edit/world_path.h"
#include "suites/scenes/procedural/parts/random.h"
#include "suites/scenes/procedural/parts/solids.h"
#include "techniques/scene/placed_scene.h"

namespace sb {
namespace {

// Toward the light. Regions: spheres in [-10,10] x [0.5,8] x [-10,10] over the floor; quads from
// height 2 to 14, shifted toward the light.
constexpr glm::dvec3 kToLight(0.35, 1.0, 0.45);
constexpr double kHalf = 10;

glm::dmat4 placed(glm::dvec3 position, glm::dmat3 turn, double scale) {
  glm::dmat4 m(turn * glm::dmat3(scale));
  m[3] = glm::dvec4(position, 1);
  return m;
}

// Uniform over all rotations (Shoemake 1992).
glm::dmat3 randomTurn(Pcg& random) {
  constexpr double kTwoPi = 6.283185307179586;
  const double u = random.uniform(), a = kTwoPi * random.uniform(), b = kTwoPi * random.uniform();
  const double x = std::sqrt(1 - u) * std::sin(a), y = std::sqrt(1 - u) * std::cos(a);
  const double z = std::sqrt(u) * std::sin(b), w = std::sqrt(u) * std::cos(b);
  return glm::dmat3(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),
                    2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
                    2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y));
}

void addSpheres(Scene& scene, const ParamValues& p) {
  const uint32_t grey = addMaterial(scene, matteMaterial("grey", glm::vec3(0.5f)));
  const uint32_t mesh =
      addMesh(scene, sphereMesh("sphere", grey, uint32_t(p.find("rings")->second)));
  Pcg random(uint64_t(p.find("seed")->second), 1);
  const uint32_t count = uint32_t(p.find("spheres")->second);
  for (uint32_t i = 0; i < count; ++i) {
    const double x = random.uniform(-kHalf, kHalf), y = random.uniform(0.5, 8);
    const double z = random.uniform(-kHalf, kHalf), radius = random.uniform(0.15, 0.35);
    addInstance(scene, "sphere" + std::to_string(i), mesh,
                placed({x, y, z}, glm::dmat3(1), radius));
  }
}

void addQuads(Scene& scene, const ParamValues& p) {
  const uint32_t count = uint32_t(p.find("quads")->second);
  if (count == 0) return;
  const uint32_t blue = addMaterial(scene, paneMaterial("blue", {0.05f, 0.15f, 1.0f}, 0.25f));
  const uint32_t mesh = addMesh(scene, quadMesh("quad", blue, glm::vec2(0.5f)));
  const bool aligned = p.find("orientation")->second == 0;
  // Aligned quads face the light.
  const glm::dmat3 facing(lookFrom(kToLight, glm::dvec3(0)));
  Pcg random(uint64_t(p.find("seed")->second), 2);
  for (uint32_t i = 0; i < count; ++i) {
    const double height = random.uniform(2, 14);
    const glm::dvec3 shift = kToLight * (0.5 * height);
    const double x = random.uniform(-kHalf, kHalf) + shift.x - 1.5;
    const double z = random.uniform(-kHalf, kHalf) + shift.z - 2;
    // Drawn for aligned quads too, so that both orientations share their places.
    const glm::dmat3 turn = randomTurn(random);
    addInstance(scene, "quad" + std::to_string(i), mesh,
                placed({x, height, z}, aligned ? facing : turn, p.find("size")->second));
  }
}

Scene make(const ParamValues& p) {
  Scene scene;
  const uint32_t white = addMaterial(scene, matteMaterial("floor", glm::vec3(0.8f)));
  const glm::dmat4 flat(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0),
                        glm::dvec4(0, 0, 0, 1));
  addInstance(scene, "floor", addMesh(scene, quadMesh("floor", white, glm::vec2(16))), flat);
  addSpheres(scene, p);
  addQuads(scene, p);
  scene.lights.push_back(sunLight(-kToLight, glm::radians(p.find("sun")->second)));
  addView(scene, {0, 17, 30}, {0, 4, 0}, 0.8, 2, 70);
  scene.background = glm::vec3(0.25f, 0.3f, 0.35f);
  return scene;
}

// Some of the spheres and quads, drawn without their order mattering, go round circles of their
// own.
void move(Scene& scene, const ParamValues& p, uint32_t steps) {
  Pcg random(uint64_t(p.find("seed")->second), 3);
  std::vector<uint32_t> rest(scene.instances.size());
  std::iota(rest.begin(), rest.end(), 0u);
  std::erase_if(rest, [&](uint32_t i) {
    return !scene.instances[i].name.starts_with("sphere") &&
           !scene.instances[i].name.starts_with("quad");
  });
  const size_t count = std::min(rest.size(), size_t(p.find("moving")->second));
  for (size_t n = 0; n < count; ++n) {
    std::swap(rest[n], rest[n + random.below(uint32_t(rest.size() - n))]);
    const glm::dmat3 frame = randomTurn(random);
    const double radius = random.uniform(0.25, 2);
    moveInstance(scene, rest[n],
                 circlePath(scene.instances[rest[n]].toWorld, frame, radius, steps));
  }
}

}  // namespace

ProceduralScene spheresQuads() {
  return {
      {"spheres_quads",
       "1000 grey spheres under a cloud of translucent blue quads (Modisett 2023, section 5.1)",
       {countParam("quads", 200, 0, 2000, "how many translucent quads"),
        {.name = "orientation",
         .choices = {"aligned", "random"},
         .help = "quads face the light, or any way"},
        {.name = "size",
         .unit = "world units",
         .fallback = 1,
         .low = 0.05,
         .high = 10,
         .help = "edge of a quad"},
        countParam("spheres", 1000, 0, 20000, "how many opaque spheres"),
        countParam("rings", 8, 3, 64, "subdivision: a sphere has 4 rings (rings - 1) triangles"),
        sunRadiusParam(),
        seedParam("places and turns"),
        {.name = "moving",
         .fallback = 0,
         .low = 0,
         .high = 22000,
         .whole = true,
         .help = "how many of the spheres and quads go round circles, in a loop of frames "
                 "(--motion steps=N)"}}},
      make,
      move};
}

}  // namespace sb
