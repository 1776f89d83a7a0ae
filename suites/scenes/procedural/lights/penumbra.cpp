// Shadows whose width can be worked out: a lamp above a floor, a board with a straight edge half
// way up, a pole that touches the floor - its shadow begins hard and grows soft - and a coloured
// pane whose penumbra lies in the board's.
#include "suites/scenes/edit/mesh_tools.h"
#include "suites/scenes/procedural/parts/solids.h"
#include "techniques/scene/light_area.h"

namespace sb {
namespace {

glm::dmat4 flatAt(double x, double y, double z) {
  return glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, -1, 0), glm::dvec4(0, 1, 0, 0),
                    glm::dvec4(x, y, z, 1));
}

Scene make(const ParamValues& p) {
  Scene scene;
  const uint32_t white = addMaterial(scene, matteMaterial("floor", glm::vec3(0.8f)));
  Material board = matteMaterial("board", glm::vec3(0.5f));
  board.doubleSided = true;
  const uint32_t grey = addMaterial(scene, board);
  const uint32_t red = addMaterial(scene, paneMaterial("pane", {0.9f, 0.15f, 0.1f}, 0.6f));
  addInstance(scene, "floor", addMesh(scene, quadMesh("floor", white, {8, 8})), flatAt(0, 0, 0));
  addInstance(scene, "board", addMesh(scene, quadMesh("board", grey, {1.5f, 1.5f})),
              flatAt(-1.5, 2, -1));
  addInstance(scene, "pole", addMesh(scene, cubeMesh("pole", grey)),
              solidAt({2.2, 1, -0.6}, {0.15, 1, 0.15}));
  addInstance(scene, "pane", addMesh(scene, quadMesh("pane", red, {0.9f, 0.6f})),
              flatAt(0, 1.2, 0.7));

  Light lamp = lampLight({0.5, 4, 0.5}, {0, -1, 0}, LightShape::Point, 0);
  const double size = p.find("size")->second;
  const double shape = p.find("light")->second;
  if (shape == 0)
    makeSphere(lamp, size);
  else if (size > 0)
    lamp = lampLight(lamp.position, lamp.direction, LightShape(shape), size);
  lamp.intensity = 3.14159265f * 16;
  scene.lights.push_back(lamp);

  addView(scene, {1, 6.5, 8}, {0.2, 0.4, 0}, 0.8, 2, 30);
  return scene;
}

}  // namespace

ProceduralScene penumbra() {
  return {{"penumbra",
           "a lamp with an extent above a board, a pole and a coloured pane",
           {{.name = "light",
             .choices = {"sphere", "ellipsoid", "rectangle", "disc"},
             .help = "shape of the lamp"},
            {.name = "size",
             .unit = "world units",
             .fallback = 0.5,
             .low = 0,
             .high = 2,
             .help = "largest half axis of the lamp; 0 casts hard shadows"}}},
          make};
}

}  // namespace sb
