#include "tests/techniques/transparency_scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/worst.h"

namespace sb::test {

Material shining(glm::vec3 color, float alpha) {
  Material m = glass(alpha, glm::vec3(0));
  m.baseColor = glm::vec4(color, 1);
  m.unlit = true;
  return m;
}

Scene stack(const std::vector<Pane>& panes, glm::vec3 background) {
  Scene scene;
  scene.name = "stack";
  scene.background = background;
  for (size_t i = 0; i < panes.size(); ++i)
    addQuad(scene, add(scene, shining(panes[i].color, panes[i].alpha)), {2, -2, -0.125f * float(i)},
            {8, 0, 0}, {0, 8, 0});
  scene.cameras.push_back(lookAt({0, 0, 3}, {0, 0, 0}, 0.6));
  return scene;
}

std::vector<Pane> panes(uint32_t count, float alpha) {
  std::vector<Pane> list;
  for (uint32_t i = 0; i < count; ++i)
    list.push_back({{float(i % 3) / 2, float(i % 4) / 3, float(i % 5) / 4}, alpha});
  return list;
}

glm::vec3 composed(const std::vector<Pane>& panes, glm::vec3 background) {
  glm::dvec3 color(background);
  for (size_t i = panes.size(); i-- > 0;) {
    const double a = double(panes[i].alpha);
    color = a * glm::dvec3(panes[i].color) + (1 - a) * color;
  }
  return glm::vec3(color);
}

Scene tangle(bool sortable) {
  Scene scene;
  scene.name = "tangle";
  scene.background = {0.25f, 0.375f, 0.5f};
  const uint32_t grey = add(scene, matte());
  addHorizontal(scene, grey, {0, -1, 0}, 4, 4);
  addBox(scene, grey, {-0.25f, -1, -0.5f}, {0.5f, 0.25f, 0.25f});
  for (int i = 0; i < 10; ++i) {
    Material material = i % 2 ? shining({float(i % 3) / 2, float(i % 4) / 3, 0.5f}, 0.375f)
                              : glass(0.5f, {1, 0.5f, 0.25f});
    const float turn = sortable ? 0.0f : 0.7f * float(i);
    addQuad(scene, add(scene, std::move(material)),
            {0.25f * float(i % 5) - 0.5f, 0.125f * float(i % 7) - 0.375f, 0.25f * float(i) - 1.5f},
            {std::cos(turn), 0, sortable ? 0.0f : std::sin(turn)}, {0, 1, 0});
  }
  addLight(scene, sun({0.375, -1, -0.25}));
  scene.cameras.push_back(lookAt({0.5, 0.75, 5}, {0, 0, 0}, 0.8));
  return scene;
}

CellOptions transparent(const std::string& transparency, std::map<std::string, std::string> knobs,
                        rhi::Extent2D size) {
  return {
      .technique = "none", .knobs = std::move(knobs), .size = size, .transparency = transparency};
}

std::vector<float> rendered(rhi::Device& device, const Scene& scene, const CellOptions& options) {
  Cell cell(cellDevice(device), scene, options);
  return cell.picture().rgba;
}

float largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
  if (a.size() != b.size()) return std::numeric_limits<float>::infinity();
  float largest = 0;
  for (size_t i = 0; i < a.size(); ++i) largest = base::worse(largest, std::abs(a[i] - b[i]));
  return largest;
}

void expectColor(const std::vector<float>& picture, glm::vec3 expected, float tolerance) {
  for (size_t i = 0; i < picture.size(); i += 4)
    for (size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(picture[i + c], expected[int(c)], tolerance)
          << "pixel " << i / 4 << ", channel " << c;
}

size_t passesOf(const Cell& cell, const std::string& label) {
  return size_t(std::ranges::count(cell.result().passes, label, &PassResult::label));
}

}  // namespace sb::test
