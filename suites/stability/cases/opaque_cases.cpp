// Opaque casters driven to where maps break (spec 17, rows of 01): huge ranges, lights behind
// receivers, casters before the near plane, lights inside casters.
#include <cmath>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/case.h"

namespace sb {
namespace {

const ProbeOptions kOptions = {.knobs = {{"kernel", "1"}, {"compare", "manual"}}, .size = {64, 64}};

Found behindTheLight(const CaseContext& context) {
  // Between the floor and a spot that looks up: the mirrored lookup would hit the lid.
  Scene scene = floorScene(false);
  addHorizontal(scene, 0, {0, 3, 0}, 2, 2);
  addLight(scene, spotLight({0, 1, 0}, {0, 1, 0}, 1.2, 10));
  addLight(scene, spotLight({0, 4, 0}, {0, 1, 0}, 1.2, 10));
  Found found;
  Probe probe(context, std::move(scene), kOptions);
  for (const uint32_t light : probe.renderer().lights()) {
    Compared lost;
    const VisibilityImage& image = probe.visibility(light)[0];
    for (size_t i = 0; i < image.size(); i += 4)
      if (image[i + 3] > 0) lost.worst(1 - double(image[i]));
    found.curve.push_back({double(light), lost.value(), 0});
  }
  return found;
}

Found farCaster(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const double height : {10.0, 1e3, 1e5, 1e7}) {
    Scene scene = floorScene();
    addHorizontal(scene, 0, {0, float(height), 0}, 4.5f, 4.5f);
    Probe probe(context, std::move(scene), kOptions);
    found.curve.push_back({height, probe.meanVisibility(0).x, 0});
  }
  return found;
}

/// A caster 1e-3 from a point light, a floor at a distance, half of it in the shadow, and an eye
/// that far from the light. Pixels of the floor that are wrong.
double wrongHalves(const CaseContext& context, double distance, double eye) {
  Scene scene;
  const uint32_t grey = add(scene, matte());
  const float far = float(distance);
  addHorizontal(scene, grey, {0, -far, 0}, far, far);
  // Covers x < 0 as the light sees the floor.
  addHorizontal(scene, grey, {-5e-3f, -1e-3f, 0}, 5e-3f, 1e-2f);
  addLight(scene, pointLight({0, 0, 0}, float(distance * distance)));
  Camera camera = downCamera({0, -eye, 0}, 0.4 * distance, 2 * distance);
  camera.nearPlane = 0.5 * distance - eye > 0 ? 0.25 * distance : 1e-3 * distance;
  scene.cameras.push_back(camera);
  Probe probe(context, std::move(scene), kOptions);
  const VisibilityImage& image = probe.visibility()[0];
  Compared wrong;
  for (uint32_t y = 8; y < 56; ++y)
    for (uint32_t x = 0; x < 64; ++x) {
      if (x >= 28 && x < 36) continue;  // the shadow's edge
      const float* v = image.data() + 4 * (y * 64 + x);
      wrong.count(v[3] == 0 || v[0] != (x < 32 ? 0.0f : 1.0f));
    }
  return wrong.value();
}

Found hugeRange(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const double distance : {1.0, 1e2, 1e4, 1e6})
    found.curve.push_back({distance, wrongHalves(context, distance, 5e-3), 0});
  return found;
}

Found farEye(const CaseContext& context) {
  Found found{.curve = {},
              .expected =
                  "positions are known relative to the eye, to 2^-24 of their "
                  "distance: a caster nearer to its light than that is lost"};
  for (const double eye : {1e-2, 1.0, 1e2, 1e3, 1e4, 1e5, 5e5})
    found.curve.push_back({eye, wrongHalves(context, 1e6, eye), 0});
  return found;
}

Found lightInside(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const float half : {0.5f, 0.01f, 1e-4f}) {
    Scene scene = floorScene(false);
    addBox(scene, 0, glm::vec3(0, 2, 0) - half, glm::vec3(0, 2, 0) + half);
    addLight(scene, pointLight({0, 2, 0}, 10));
    Probe probe(context, std::move(scene), kOptions);
    found.curve.push_back({half, probe.meanVisibility(0).x, 0});
  }
  return found;
}

}  // namespace

std::vector<StabilityCase> opaqueCases() {
  return {
      {.id = "behind",
       .title = "Receivers behind a spot light",
       .property = "no mirrored shadow (light lost)",
       .reason = "exact: w is tested first",
       .run = behindTheLight},
      {.id = "far caster",
       .title = "Casters far before the view",
       .property = "they still cast (light that arrives)",
       .reason = "exact: depth is clamped",
       .parameter = "height, world units",
       .logarithmic = true,
       .run = farCaster},
      {.id = "range",
       .title = "A caster 1e-3 from a point light",
       .property = "the floor is lit or dark as it should be (wrong pixels away from the edge)",
       .reason = "none: depth n / z keeps its relative precision (N3)",
       .parameter = "distance of the floor, world units",
       .logarithmic = true,
       .run = hugeRange},
      {.id = "far eye",
       .title = "The same, with floor 1e6 away and an eye far from the light",
       .property = "the floor is lit or dark as it should be (wrong pixels away from the edge)",
       .reason = "nothing is allowed",
       .parameter = "eye to light, world units",
       .logarithmic = true,
       .run = farEye},
      {.id = "inside",
       .title = "A light inside a closed caster",
       .property = "nothing outside is lit (light that arrives)",
       .reason = "exact",
       .parameter = "half width of the caster, world units",
       .logarithmic = true,
       .run = lightInside},
  };
}

}  // namespace sb
