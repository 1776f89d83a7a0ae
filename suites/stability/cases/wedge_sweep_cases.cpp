// Curves of spec 17 for soft shadows (H2, H3, H5, H6 and the rows of 08 that have a parameter):
// what happens to shares while a receiver goes past a wedge's apex, a light grows or goes through a
// caster, layers pile up, the eye goes through volumes and wedges, the world stands far from zero.
#include "suites/scenes/edit/transform.h"
#include "suites/stability/cases/wedge_scenes.h"

namespace sb {
namespace {

/// H6: a receiver goes past the apex of a wedge, 1024 places across a penumbra of any width.
Found pastApex(const CaseContext& context) {
  Found found;
  // Narrower, and floats do not tell the places apart: the casters are 1e7 of them wide.
  for (const double gap : {1e-2, 0.1, 1.0}) {
    Scene scene;
    Material thin = matte();
    thin.doubleSided = true;
    add(scene, thin);
    addHorizontal(scene, 0, {0, 0, 0}, 4, 4);
    addHorizontal(scene, 0, {1, float(gap), 0}, 1, 1);
    Light light = pointLight({0, float(gap) + 4, 0}, 20);
    makeSphere(light, 0.5);
    addLight(scene, light);
    // The penumbra is gap / 8 to both sides of x = 0; the eye looks under the sheet, at 45 degrees.
    const double side = std::sqrt(0.5);
    Camera camera = downCamera({0, 0, 0}, 0.14 * gap * side / 1024, 8 * gap);
    camera.nearPlane = 0.5 * gap;
    camera.toWorld = glm::dmat4(glm::dvec4(side, side, 0, 0), glm::dvec4(0, 0, -1, 0),
                                glm::dvec4(-side, side, 0, 0), glm::dvec4(-2 * gap, 2 * gap, 0, 1));
    scene.cameras = {camera};
    Probe probe(context, std::move(scene), {.size = {1024, 1}});
    const VisibilityImage& shares = probe.visibility(0)[0];
    double step = 0, least = 1, most = 0;
    for (size_t x = 0; x < 1024; ++x) {
      const double share = shares[4 * x];
      least = std::min(least, std::isfinite(share) ? share : -kNever);
      most = std::max(most, std::isfinite(share) ? share : kNever);
      if (x > 0) step = std::max(step, std::abs(share - shares[4 * (x - 1)]));
    }
    // From all of the light to none of it.
    found.curve.push_back(
        {gap, least > 0.01 || most < 0.99 || most > 1 ? kNever : step, 4.0 / 1024 + 1e-3});
  }
  return found;
}

Found radius(const CaseContext& context) {
  return worstAlong(context, {1e-6, 1e-3, 0.1, 0.5, 2, 2.75}, [](double size) {
    Scene scene = lamp(size);
    addHorizontal(scene, 0, {0.25, 1, 0.125}, 0.75f, 0.5f);
    return scene;
  });
}

/// A light that holds casters, and the floor.
Found hugeLight(const CaseContext& context) {
  Found found;
  for (const double size : {3.0, 3.5, 4.0, 8.0}) {
    Scene scene = lamp(size);
    addHorizontal(scene, 0, {0.25, 1, 0.125}, 0.75f, 0.5f);
    Probe probe(context, std::move(scene), {.size = {48, 36}});
    found.curve.push_back({size, badValues(probe), 0});
  }
  return found;
}

Found layers(const CaseContext& context) {
  Found found;
  for (const uint32_t count : {1u, 8u, 255u, 256u, 257u, 600u}) {
    Scene scene = lamp();
    for (uint32_t i = 0; i < count; ++i)
      addHorizontal(scene, 0, {0.125, 0.5 + double(i) / 600, 0}, 0.5f, 0.375f);
    found.curve.push_back(
        {double(count), shareErrors(context, std::move(scene)).lighter.value(), kTolerance});
  }
  return found;
}

/// A small light goes down through a box: above it, whole within, below it.
Found throughCaster(const CaseContext& context) {
  return worstAlong(context, {1.5, 1.3125, 1, 0.6875, 0.5}, [](double height) {
    Scene scene = lamp(0.03125);
    scene.lights[0].position.y = height;
    addBox(scene, 0, {-0.75f, 0.75f, -0.5f}, {0.75f, 1.25f, 0.5f});
    return scene;
  });
}

/// H5: a light half in a wall.
Found halfInWall(const CaseContext& context) {
  Found found;
  for (const double aside : {-0.25, 0.0, 0.25}) {
    Scene scene = lamp();
    addBox(scene, 0, {float(aside), 2, -2}, {float(aside) + 0.5f, 5, 2});
    Probe probe(context, std::move(scene), {.size = {48, 36}});
    found.curve.push_back({aside, badValues(probe), 0});
  }
  return found;
}

/// H3: the eye goes through the wedges and the volume of a box, and past the box's own box.
Found eyeThrough(const CaseContext& context) {
  return worstAlong(context, {-2, -1, -0.75, -0.5, 0, 0.5}, [](double x) {
    Scene scene = lamp(0.25, {x, 0.25, 0.125});
    scene.cameras[0] = lookAt({x, 0.25, 0.125}, {x + 1, -0.25, 0.25}, 1);
    addBox(scene, 0, {-0.5f, 0.75f, -0.5f}, {0.5f, 1, 0.5f});
    return scene;
  });
}

/// H2: far from zero every share stays as it is.
Found farFromZero(const CaseContext& context) {
  const auto scene = [] {
    Scene made = lamp();
    addBox(made, 0, {-0.75f, 0.5f, -0.5f}, {0.5f, 1.25f, 0.5f});
    return made;
  };
  Probe near(context, scene(), {.size = {48, 36}});
  const VisibilityImage expected = near.visibility(0)[0];
  Found found;
  for (const double offset : {1e3, 1e6, 1e7}) {
    Scene moved = scene();
    translateScene(moved, {offset, -2 * offset, 3 * offset});
    Probe far(context, std::move(moved), {.size = {48, 36}});
    const VisibilityImage& shares = far.visibility(0)[0];
    double worst = 0;
    for (size_t i = 0; i < shares.size(); ++i) {
      const double error = std::abs(double(shares[i]) - double(expected[i]));
      worst = std::max(worst, std::isfinite(error) ? error : kNever);
    }
    found.curve.push_back({offset, worst, 1e-3});
  }
  return found;
}

}  // namespace

std::vector<StabilityCase> wedgeSweepCases() {
  std::vector<StabilityCase> cases = {
      wedgeCase("H6", "A receiver goes past the apex of a wedge", "below it, world units",
                pastApex),
      wedgeCase("light radius", "A light from a point to nearly its casters", "radius", radius),
      wedgeCase("huge light", "A light that holds casters and receivers", "radius", hugeLight),
      wedgeCase("penumbra layers", "Layers before a light", "layers", layers),
      wedgeCase("light through caster", "A light goes through a closed caster", "its height",
                throughCaster),
      wedgeCase("H5", "A light half in a wall", "from its centre, world units", halfInWall),
      wedgeCase("eye through wedges", "An eye goes through wedges and volumes", "its place",
                eyeThrough),
      wedgeCase("penumbra offset", "A world far from zero", "offset, world units", farFromZero)};
  cases[0].property = "shares of neighbouring places are alike (largest step of 1024)";
  cases[0].reason = "4 steps of a disc's widest chord and the mask's half floats";
  cases[3].property = kNoLighter;
  for (const size_t i : {2, 5}) {
    cases[i].property = kFiniteShares;
    cases[i].reason = "exact";
  }
  cases[7].property = "visibility is that near zero (largest difference)";
  cases[7].reason = "all is made relative to the eye in double";
  return cases;
}

}  // namespace sb
