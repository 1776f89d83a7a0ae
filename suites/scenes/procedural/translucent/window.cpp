// Modisett 2023, section 5.3.2: white light through a quad textured with a rose window onto a
// white surface. The window stands upright before the light, the receiver lies behind it, turned
// toward the camera, so that the picture holds both.
#include "suites/scenes/edit/framing.h"
#include "suites/scenes/procedural/scenes.h"
#include "suites/scenes/procedural/translucent/rose_window.h"

namespace sb {
namespace {

Scene make(const ParamValues& p) {
  Scene scene;
  scene.images.push_back(roseWindowImage(uint32_t(p.find("resolution")->second)));
  const uint32_t white = addMaterial(scene, matteMaterial("white", glm::vec3(0.9f)));
  Material glass = paneMaterial("rose window", glm::vec3(1), 1);
  glass.baseColorTexture = {
      .image = 0, .wrapU = Wrap::ClampToEdge, .wrapV = Wrap::ClampToEdge, .srgb = true};
  const uint32_t rose = addMaterial(scene, glass);

  // Both are turned toward the light, which comes from behind the camera's left shoulder.
  const glm::dvec3 hung(-3.5, 0.2, 2.0), wall(2.9, 0, -3.0);
  addInstance(scene, "window", addMesh(scene, quadMesh("window", rose, glm::vec2(2.6f))),
              lookFrom(hung, hung - glm::dvec3(-0.35, 0, 1)));
  addInstance(scene, "receiver", addMesh(scene, quadMesh("receiver", white, {4.0f, 4.0f})),
              lookFrom(wall, wall - glm::dvec3(-0.3, 0, 1)));
  scene.lights.push_back(chosenLight(p, {1.2, -0.05, -1}, wall, 16));

  addView(scene, {-0.1, 0.6, 17}, {-0.1, 0, -1}, 0.8, 2, 50);
  return scene;
}

}  // namespace

ProceduralScene roseWindow() {
  return {{"window",
           "white light through a rose window onto a white wall (Modisett 2023, section 5.3.2)",
           withLight({{.name = "resolution",
                       .unit = "texels",
                       .fallback = 1024,
                       .low = 1024,
                       .high = 4096,
                       .whole = true,
                       .help = "width and height of the window's texture"}})},
          make};
}

}  // namespace sb
