// Modisett 2023, figure 2.1.2.A: what a wrong order of translucent surfaces looks like. A
// large green pane stands aslant before a white wall; a red one before its far end, a blue one
// behind its near end. By their centres red is the farthest and blue the nearest, which is wrong
// for both; by triangles the order is right. The panes' shadows lie on the wall.
#include "suites/scenes/edit/framing.h"
#include "suites/scenes/procedural/scenes.h"

namespace sb {
namespace {

/// A quad of `steps` x `steps` smaller ones, so that triangles can be sorted.
Mesh gridMesh(std::string name, uint32_t material, glm::vec2 half, uint32_t steps) {
  Mesh mesh = quadMesh(std::move(name), material, half);
  mesh.positions.clear(), mesh.normals.clear(), mesh.uv0.clear(), mesh.indices.clear();
  for (uint32_t j = 0; j <= steps; ++j)
    for (uint32_t i = 0; i <= steps; ++i) {
      const glm::vec2 at(float(i) / float(steps), float(j) / float(steps));
      mesh.positions.emplace_back(half * (2.0f * at - 1.0f), 0);
      mesh.normals.emplace_back(0, 0, 1);
      mesh.uv0.emplace_back(at.x, 1 - at.y);
    }
  for (uint32_t j = 0; j < steps; ++j)
    for (uint32_t i = 0; i < steps; ++i) {
      const uint32_t a = j * (steps + 1) + i, b = a + steps + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  return mesh;
}

Scene make(const ParamValues& p) {
  Scene scene;
  const float alpha = float(p.find("alpha")->second);
  const uint32_t white = addMaterial(scene, matteMaterial("white", glm::vec3(0.9f)));
  const uint32_t green = addMaterial(scene, paneMaterial("green", {0.1f, 0.75f, 0.15f}, alpha));
  const uint32_t red = addMaterial(scene, paneMaterial("red", {0.95f, 0.08f, 0.06f}, alpha));
  const uint32_t blue = addMaterial(scene, paneMaterial("blue", {0.06f, 0.18f, 0.95f}, alpha));
  const auto at = [](double x, double y, double z) {
    glm::dmat4 m(1);
    m[3] = glm::dvec4(x, y, z, 1);
    return m;
  };
  addInstance(scene, "wall", addMesh(scene, quadMesh("wall", white, {5.5f, 4})), at(0, 0, -3));
  // Its right end is the near one: z rises by 0.6 of x.
  addInstance(scene, "green pane", addMesh(scene, gridMesh("green", green, {3, 1.3f}, 24)),
              lookFrom({0, 0, 0}, {0.6, 0, -1}));
  addInstance(scene, "red pane", addMesh(scene, quadMesh("red", red, {0.8f, 1.6f})),
              at(-1.6, 0.4, -0.35));
  addInstance(scene, "blue pane", addMesh(scene, quadMesh("blue", blue, {0.8f, 1.6f})),
              at(1.6, -0.4, 0.35));
  scene.lights.push_back(sunLight({0.35, -0.5, -1}, glm::radians(p.find("sun")->second)));
  addView(scene, {0, 0.3, 14}, {0, 0, 0}, 0.7, 2, 30);
  return scene;
}

}  // namespace

ProceduralScene panes() {
  return {{"panes",
           "three panes whose centres tell the wrong order (Modisett 2023, figure 2.1.2.A)",
           {{.name = "alpha", .fallback = 0.7, .low = 0, .high = 1, .help = "opacity of the panes"},
            sunRadiusParam()}},
          make};
}

}  // namespace sb
