// Scenes of the tests of camera transparency: stacks of panes that are worked out by hand, and a
// tangle of panes that cross each other.
#pragma once

#include "suites/scenes/procedural/parts/shapes.h"
#include "tests/techniques/gpu_cell.h"

namespace sb::test {

/// Techniques that compose fragments exactly.
inline const std::vector<std::string> kExactTransparency = {"DepthPeeling", "DualDepthPeeling",
                                                            "LinkedLists"};

/// So nearly opaque that half floats cannot tell; 1 itself would make an opaque surface.
inline constexpr float kAll = 1 - 0x1p-20f;

/// Panes cover the picture with one of their two triangles.
struct Pane {
  glm::vec3 color;
  float alpha = 0.5f;
};

/// Of the given opacity, shining with its own colour whatever the light.
Material shining(glm::vec3 color, float alpha);

/// Panes front to back, each filling the picture, before a background.
Scene stack(const std::vector<Pane>& panes, glm::vec3 background);
/// `count` panes of the same opacity in changing colours.
std::vector<Pane> panes(uint32_t count, float alpha);
/// What a pixel of the stack shows.
glm::vec3 composed(const std::vector<Pane>& panes, glm::vec3 background);

/// Panes that cross each other, an opaque box and an opaque floor that cut them; the sun above.
/// `sortable`: parallel panes that do not cross.
Scene tangle(bool sortable = false);

CellOptions transparent(const std::string& transparency,
                        std::map<std::string, std::string> knobs = {},
                        rhi::Extent2D size = {16, 16});
std::vector<float> rendered(rhi::Device& device, const Scene& scene, const CellOptions& options);
float largestDifference(const std::vector<float>& a, const std::vector<float>& b);
/// Every pixel within `tolerance` of a colour.
void expectColor(const std::vector<float>& picture, glm::vec3 expected, float tolerance);
/// Passes of that label in the last frame.
size_t passesOf(const Cell& cell, const std::string& label);

}  // namespace sb::test
