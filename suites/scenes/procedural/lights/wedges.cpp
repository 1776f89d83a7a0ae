// The benchmark of the third source document (figure B.6, section 4.5): solids over a floor under
// lamps, in growing numbers, so that silhouette edges and with them penumbra wedges grow. Its four
// scenes of 4, 64, 538 and 756 edges are, within 5 %, `objects=1`, `lights=2,objects=4`,
// `lights=7,objects=10` and `lights=7,objects=13`.
#include <cmath>
#include <span>

#include "suites/scenes/procedural/parts/solids.h"

namespace sb {
namespace {

constexpr double kRange = 14;

/// The first is a board right below the first lamp, whose silhouette is a square.
void addObject(Scene& scene, std::span<const uint32_t> meshes, uint32_t number) {
  if (number == 0) {
    addInstance(scene, "object0", meshes[0], solidAt({0, 1.2, 0}, {0.7, 0.05, 0.7}));
    return;
  }
  // Sunflower: evenly spread over a disc that grows with their number.
  const double turn = 2.399963 * number, radius = 1.35 * std::sqrt(double(number));
  const double half = 0.35 + 0.05 * (number % 3);
  const glm::dvec3 middle(radius * std::cos(turn), 0.25 + half, radius * std::sin(turn));
  addInstance(scene, "object" + std::to_string(number), meshes[number % meshes.size()],
              solidAt(middle, glm::dvec3(half), 0.5 * number));
}

void addLamps(Scene& scene, uint32_t count, double radius) {
  for (uint32_t i = 0; i < count; ++i) {
    const double turn = 2.399963 * i, aside = i == 0 ? 0 : 1.2 + 0.2 * i;
    addLamp(scene, {aside * std::cos(turn), 4.5, aside * std::sin(turn)}, radius, kRange,
            48.0f / float(count));
  }
}

Scene make(const ParamValues& p) {
  Scene scene;
  const uint32_t white = addMaterial(scene, matteMaterial("floor", glm::vec3(0.7f)));
  const uint32_t blue = addMaterial(scene, matteMaterial("solid", {0.25f, 0.35f, 0.6f}));
  Mesh floor = quadMesh("floor", white, glm::vec2(12));
  addInstance(scene, "floor", addMesh(scene, std::move(floor)),
              glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0),
                         glm::dvec4(0, 0, 0, 1)));
  const uint32_t meshes[] = {
      addMesh(scene, cubeMesh("cube", blue)), addMesh(scene, columnMesh("prism", blue, 3)),
      addMesh(scene, columnMesh("column", blue, 8)), addMesh(scene, sphereMesh("ball", blue, 4))};
  const uint32_t objects = uint32_t(p.find("objects")->second);
  for (uint32_t i = 0; i < objects; ++i) addObject(scene, meshes, i);
  addLamps(scene, uint32_t(p.find("lights")->second), p.find("size")->second);
  scene.ambient = glm::vec3(0.03f);
  addView(scene, {0, 8, 9}, {0, 0.3, 0}, 0.8, 1, 30);
  return scene;
}

void move(Scene& scene, const ParamValues& p, uint32_t steps) {
  circleOnGround(scene, "object", p.find("moving")->second, 1, 1, steps);
}

}  // namespace

ProceduralScene wedges() {
  return {{"wedges",
           "solids over a floor under lamps: silhouette edges in growing numbers",
           {countParam("lights", 1, 1, 100, "how many lamps"),
            countParam("objects", 5, 1, 2000, "how many solids"), lampRadiusParam(0.3),
            movingShareParam("solids")}},
          make,
          move};
}

}  // namespace sb
