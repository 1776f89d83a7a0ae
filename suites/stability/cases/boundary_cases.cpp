// Boundaries of maps and numbers (spec 17, rows of 01-04): ties between texels, surfaces in
// contact, receivers on the far plane, surfaces that are not there, probabilities of exactly 0
// and 1.
#include <algorithm>
#include <cmath>

#include "base/worst.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/case.h"

namespace sb {
namespace {

ProbeOptions single(const std::string& mapSize, rhi::Extent2D size) {
  return {.knobs = {{"kernel", "1"}, {"size", mapSize}, {"compare", "manual"}}, .size = size};
}

/// Panes and a box whose edges lie on the grid that the light's texels are snapped to.
Scene gridded() {
  Scene scene = floorScene();
  addBox(scene, 0, {-2, 1, -2}, {0, 2, 0});
  addHorizontal(scene, add(scene, glass(0.5f, {1, 0.5f, 0})), {1.5f, 1, 1}, 1.5f, 2);
  return scene;
}

Found ties(const CaseContext& context) {
  Found found;
  for (const int size : {4, 8, 16, 64, 256, 1024}) {
    if (context.quick && size != 8 && size != 64) continue;
    ProbeOptions options = single(std::to_string(size), {64, 64});
    Probe here(context, gridded(), options);
    options.onOther = true;
    Probe there(context, gridded(), options);
    const VisibilityImage &a = here.visibility()[0], &b = there.visibility()[0];
    Compared differ;
    for (size_t i = 0; i < a.size(); i += 4)
      if (a[i + 3] != 0 || b[i + 3] != 0)
        differ.count(!std::equal(a.begin() + long(i), a.begin() + long(i) + 4, b.begin() + long(i)));
    found.curve.push_back({double(size), differ.value(), 0});
  }
  return found;
}

/// Whether a quad that far before a wall casts its whole shadow on it. A point light at the origin
/// with another caster next to it, which draws the near plane close.
bool casts(const CaseContext& context, float wall, float nearest, float gap) {
  Scene scene;
  const uint32_t grey = add(scene, matte());
  addLight(scene, pointLight({0, 0, 0}, wall * wall));
  addQuad(scene, grey, {0, 0, -wall}, {wall, 0, 0}, {0, wall, 0});
  addQuad(scene, grey, {0.4f * nearest, 0, -nearest}, {0.125f * nearest, 0, 0},
          {0, 0.125f * nearest, 0});
  addQuad(scene, grey, {-wall / 4, 0, -(wall - gap)}, {wall / 4, 0, 0}, {0, wall / 4, 0});
  // Through the wall from behind, where the quad is not seen: world x runs to the left.
  scene.cameras.push_back(lookAt({0, 0, -2 * wall}, {0, 0, 0}, 1.4, 4 * wall));
  scene.cameras[0].nearPlane = wall / 4;
  Probe probe(context, std::move(scene), single("1024", {96, 96}));
  const VisibilityImage& image = probe.visibility()[0];
  Compared lit;
  for (uint32_t y = 40; y < 56; ++y)
    for (uint32_t x = 56; x < 68; ++x)
      if (image[4 * (y * 96 + x) + 3] != 0) lit.worst(double(image[4 * (y * 96 + x)]));
  return lit.value() == 0;
}

Found contact(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::OpaqueCasters)};
  for (const double z : {4.0, 1e2, 1e4, 1e6}) {
    if (context.quick && z != 1e4) continue;
    // Positions are floats relative to the eye: the caster next to the light grows with the wall.
    const double nearest = std::max(1e-3, z * 1e-4), nearPlane = 0.6 * nearest;
    const double step = z * z / nearPlane * (context.is("depth", "d16") ? 0x1p-16 : 0x1p-24);
    const double allowed = std::max(2 * step, 24 * z * 0x1p-24);
    double share = 0x1p-16;
    while (share < 8 &&
           !casts(context, float(z), float(nearest), float(std::min(share * allowed, z / 2))))
      share *= 2;
    found.curve.push_back({z, share, 1});
  }
  return found;
}

Found farPlane(const CaseContext& context) {
  // The floor is the last receiver: part of it lies on the far plane of the fitted light.
  Found found;
  for (const double slant : {0.0, 0.25, 0.5, 1.0}) {
    Scene scene = floorScene();
    scene.lights[0] = sun({slant, -1, slant / 2});
    addHorizontal(scene, add(scene, glass(0.75f, {1, 0.5f, 0})), {3, 0.25f, 0}, 0.5f, 3);
    Probe probe(context, std::move(scene), single("256", {64, 64}));
    const VisibilityImage& image = probe.visibility()[0];
    double lost = 0;
    for (uint32_t y = 0; y < 64; ++y)
      for (uint32_t x = 0; x < 48; ++x)
        for (uint32_t c = 0; c < 3; ++c)
          lost = base::worse(lost, 1 - double(image[4 * (y * 64 + x) + c]));
    found.curve.push_back({slant, lost, 0});
  }
  return found;
}

Found cutOut(const CaseContext& context) {
  Found found;
  const auto with = [](std::optional<float> t) {
    Scene scene = gridded();
    if (t) addHorizontal(scene, add(scene, glass(0, glm::vec3(*t))), {0, 0.5f, 0}, 3, 3);
    scene.cameras[0] = lookAt({3, 4, 5}, {0, 0, 0});
    return scene;
  };
  const ProbeOptions options = single("256", {96, 64});
  Probe before(context, with({}), options);
  for (const float t : {0.0f, 0.25f, 1.0f}) {
    Probe after(context, with(t), options);
    found.curve.push_back({t, pictureDifference(before, after), 0});
  }
  return found;
}

/// Values of the floor that are not `expected` under a pane, over all draws.
double wrongDraws(const CaseContext& context, const glm::vec3& t, const glm::vec3& expected) {
  Scene scene = floorScene();
  addHorizontal(scene, add(scene, glass(1, t)), {0, 1, 0}, 4.5f, 4.5f);
  const uint32_t size = context.quick ? 128 : 1024, seeds = context.quick ? 1 : 16;
  Probe probe(context, std::move(scene), single(std::to_string(size), {size, size}));
  Compared wrong;
  for (uint32_t seed = 0; seed < seeds; ++seed) {
    probe.renderer().setSeed(seed);
    probe.renderer().frame();
    const VisibilityImage image = probe.renderer().readVisibility(0)[0];
    for (size_t i = 0; i < image.size(); i += 4)
      for (int c = 0; c < 3; ++c)
        if (image[i + 3] != 0 && expected[c] >= 0)
          wrong.count(image[i + size_t(c)] != expected[c]);
  }
  return wrong.value();
}

Found certainDraws(const CaseContext& context) {
  Found found;
  if (context.represents(Effect::ColouredTransmission)) {
    // Channels that never, always and sometimes block: nothing can be left out.
    found.curve.push_back({0, wrongDraws(context, {1, 0.5f, 0.5f}, {1, -1, -1}), 0});
    found.curve.push_back({1, wrongDraws(context, {0.5f, 0.5f, 0}, {-1, -1, 0}), 0});
  } else {
    found.curve.push_back({0, wrongDraws(context, glm::vec3(1), glm::vec3(1)), 0});
    found.curve.push_back({1, wrongDraws(context, glm::vec3(0), glm::vec3(0)), 0});
  }
  return found;
}

std::string ofStochastic(const CaseContext& context) {
  return context.info().stochastic ? "" : "it draws no random numbers";
}

std::string withOther(const CaseContext& context) {
  return context.other ? "" : "no other API is here to compare with";
}

}  // namespace

std::vector<StabilityCase> boundaryCases() {
  return {
      {.id = "ties",
       .title = "Edges on the borders of texels",
       .property = "both APIs decide alike (pixels that differ)",
       .reason = "none: one convention for half texels",
       .parameter = "map size, texels",
       .logarithmic = true,
       .leavesOut = withOther,
       .run = ties},
      {.id = "contact",
       .title = "A quad just before a wall under a point light",
       .property = "it casts its whole shadow (smallest gap that does, over what is allowed)",
       .reason = "two depth steps of a conventional map (N3), or 24 half-ulps of the distance (N4)",
       .parameter = "distance, world units",
       .logarithmic = true,
       .run = contact},
      {.id = "far plane",
       .title = "Receivers on the light's far plane",
       .property = "they are lit (light lost)",
       .reason = "exact",
       .parameter = "slant of the light",
       .run = farPlane},
      {.id = "cut-out",
       .title = "A surface of alpha 0",
       .property = "the picture is the one without it (largest difference, 1/255)",
       .reason = "exact",
       .parameter = "t",
       .run = cutOut},
      {.id = "certain",
       .title = "Probabilities 0 and 1 over 2^24 draws",
       .property = "never or always blocked (values that are not)",
       .reason = "exact: numbers lie in [0, 1), and xi < p blocks",
       .parameter = "p",
       .leavesOut = ofStochastic,
       .run = certainDraws},
  };
}

}  // namespace sb
