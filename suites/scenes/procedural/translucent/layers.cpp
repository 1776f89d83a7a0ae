// Modisett 2023, section 5.3.3: white directional light through blue, grey and rainbow quads
// onto an opaque white quad. The panes stand one behind the other as the light sees them, grey
// nearest, rainbow in the middle, blue last, each shifted so that from the light every pair and the
// triple overlap and each is also seen alone; the camera looks from the side, so that the panes and
// their shadows on one another and on the white quad lie apart in the picture.
#include <cmath>

#include "suites/scenes/procedural/scenes.h"

namespace sb {
namespace {

uint8_t toSrgb(double linear) {
  const double s = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return uint8_t(std::lround(255 * glm::clamp(s, 0.0, 1.0)));
}

// Full-saturation hues from red on the left to violet on the right, each a vertical line.
Image rainbowImage(uint32_t width, uint32_t height) {
  Image image{"rainbow", width, height, std::vector<uint8_t>(size_t(width) * height * 4)};
  for (uint32_t x = 0; x < width; ++x) {
    const double hue = 5.0 * (x + 0.5) / width;  // sextants; 5 is violet-red's start
    const auto channel = [&](double center) {
      const double away = std::abs(std::remainder(hue - center, 6.0));
      return glm::clamp(2.0 - away, 0.0, 1.0);
    };
    const uint8_t rgb[3] = {toSrgb(channel(0)), toSrgb(channel(2)), toSrgb(channel(4))};
    for (uint32_t y = 0; y < height; ++y) {
      uint8_t* texel = image.rgba.data() + 4 * (size_t(y) * width + x);
      texel[0] = rgb[0], texel[1] = rgb[1], texel[2] = rgb[2], texel[3] = 255;
    }
  }
  return image;
}

Scene make(const ParamValues& p) {
  Scene scene;
  const float alpha = float(p.find("alpha")->second);
  scene.images.push_back(rainbowImage(uint32_t(p.find("resolution")->second), 16));
  const uint32_t white = addMaterial(scene, matteMaterial("white", glm::vec3(0.9f)));
  const uint32_t grey = addMaterial(scene, paneMaterial("grey", glm::vec3(0.4f), alpha));
  Material rainbowPane = paneMaterial("rainbow", glm::vec3(1), alpha);
  rainbowPane.baseColorTexture = {
      .image = 0, .wrapU = Wrap::ClampToEdge, .wrapV = Wrap::ClampToEdge, .srgb = true};
  const uint32_t rainbow = addMaterial(scene, rainbowPane);
  const uint32_t blue = addMaterial(scene, paneMaterial("blue", {0.05f, 0.15f, 1.0f}, alpha));

  // The white quad stands upright at z = 0; panes stand before it, parallel to it.
  const auto at = [](double x, double y, double z) {
    glm::dmat4 m(1);
    m[3] = glm::dvec4(x, y, z, 1);
    return m;
  };
  addInstance(scene, "receiver", addMesh(scene, quadMesh("receiver", white, {6.2f, 4.2f})),
              at(1.6, 0, 0));
  const glm::dvec3 travel(1.6, -0.3, -1);
  const double gap = p.find("gap")->second;
  // A pane `layer` gaps before the receiver whose shadow's middle falls on (x, y).
  const auto pane = [&](const char* name, uint32_t material, glm::vec2 half, int layer, double x,
                        double y) {
    const double z = gap * layer;
    addInstance(scene, name, addMesh(scene, quadMesh(name, material, half)),
                at(x - travel.x * z, y - travel.y * z, z));
  };
  pane("blue", blue, {1.6f, 1.6f}, 1, 1.2, -0.9);
  pane("rainbow", rainbow, {2.2f, 1.6f}, 2, 2.6, 0.0);
  pane("grey", grey, {1.6f, 1.6f}, 3, 3.6, 1.2);
  scene.lights.push_back(sunLight(travel, glm::radians(p.find("sun")->second)));

  addView(scene, {5, 2.5, 22.5}, {-0.7, 0.5, 0.5}, 0.8, 2, 60);
  return scene;
}

}  // namespace

ProceduralScene layers() {
  return {{"layers",
           "white light through grey, rainbow and blue quads onto a white one (Modisett 2023, 5.3.3)",
           {{.name = "alpha",
             .fallback = 0.6,
             .low = 0,
             .high = 1,
             .help = "opacity of the three panes"},
            {.name = "gap",
             .unit = "world units",
             .fallback = 1.5,
             .low = 0.1,
             .high = 2,
             .help = "distance between one layer and the next"},
            {.name = "resolution",
             .unit = "texels",
             .fallback = 512,
             .low = 8,
             .high = 4096,
             .whole = true,
             .help = "width of the rainbow texture"},
            sunRadiusParam()}},
          make};
}

}  // namespace sb
