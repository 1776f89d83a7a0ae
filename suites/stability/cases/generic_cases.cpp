// Properties of every technique (spec 17, section 1): scenes that are moved, scaled, permuted,
// doubled, degenerate, perturbed or empty; both APIs; the corners of alpha and t; grazing light.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/case.h"

namespace sb {
namespace {

/// Opaque boxes, tinted panes that overlap, a floor; a light of every type. Coordinates are
/// multiples of 1/64, so that moving by what floats can add to them, and scaling by powers of two,
/// is exact.
Scene mixed(bool localLights) {
  Scene scene;
  scene.name = "mixed";
  const uint32_t grey = add(scene, matte()), red = add(scene, matte({0.75f, 0.25f, 0.125f}));
  addHorizontal(scene, grey, {0, 0, 0}, 4, 4);
  addBox(scene, red, {-1.5f, 0, -1}, {-0.5f, 1.25f, 0});
  addBox(scene, red, {0.5f, 0.25f, 0.5f}, {1.25f, 0.75f, 1.5f});
  addQuad(scene, add(scene, glass(0.75f, {0.25f, 0.5f, 1})), {0.5f, 1, -0.5f}, {0.75f, 0.25f, 0},
          {0, 0.5f, 0.5f});
  addQuad(scene, add(scene, glass(0.5f, {1, 0.5f, 0.25f})), {0.25f, 1.75f, -0.25f},
          {0.5f, 0, 0.25f}, {0, 0.25f, 0.75f});
  addLight(scene, sun({0.375, -1, -0.25}));
  if (localLights) {
    addLight(scene, pointLight({1.5, 2.25, 0.5}, 4));
    addLight(scene, spotLight({-1.5, 3, 1.5}, {0.5, -1, -0.5}, 0.75, 6));
  }
  scene.cameras.push_back(lookAt({2.5, 3, 4}, {0, 0.25, 0}));
  return scene;
}

const ProbeOptions kOptions = {.knobs = {{"kernel", "3"}, {"compare", "manual"}}};

/// Differences between a scene and changed ones, at parameter values.
template <class Change>
Found changed(const CaseContext& context, bool localLights, const std::vector<double>& parameters,
              double tolerance, const Change& change) {
  Found found;
  Probe before(context, mixed(localLights), kOptions);
  for (const double x : parameters) {
    Scene scene = mixed(localLights);
    change(scene, x);
    Probe after(context, std::move(scene), kOptions);
    found.curve.push_back({x, pictureDifference(before, after), tolerance});
  }
  return found;
}

Found translated(const CaseContext& context) {
  // Along (1, -2, 3): what a float world matrix would lose grows with the offset.
  return changed(context, true, {1e3, 1e5, 1e6, 1e7, 1e9}, 0, [](Scene& scene, double x) {
    translateScene(scene, {x, -2 * x, 3 * x});
  });
}

Found scaled(const CaseContext& context) {
  return changed(context, true, {0x1p-20, 0x1p-10, 0x1p-3, 0x1p3, 0x1p10, 0x1p20}, 0,
                 [](Scene& scene, double x) { scaleScene(scene, x); });
}

Found permuted(const CaseContext& context) {
  // Products in half floats round in the order of drawing: 3 layers at 2^-11 are under 1/255.
  const double tolerance =
      context.info().stochastic || !context.represents(Effect::TranslucentCasters) ? 0 : 1;
  return changed(context, false, {1, 2, 3}, tolerance,
                 [](Scene& scene, double x) { permuteScene(scene, uint64_t(x)); });
}

Found permutedLights(const CaseContext& context) {
  return changed(context, true, {4, 5}, 1,
                 [](Scene& scene, double x) { permuteScene(scene, uint64_t(x)); });
}

Found doubled(const CaseContext& context) {
  return changed(context, true, {2}, 0, [](Scene& scene, double) { duplicateOpaque(scene); });
}

Found degenerate(const CaseContext& context) {
  return changed(context, true, {1}, 0, [](Scene& scene, double) { insertDegenerate(scene); });
}

Found perturbed(const CaseContext& context) {
  Found found;
  const ProbeOptions options{.knobs = {{"kernel", "1"}, {"compare", "manual"}}};
  Probe before(context, mixed(false), options);
  for (const double x : {1e-7, 1e-6}) {
    Scene scene = mixed(false);
    scene.instances[1].toWorld[3].x += 1.5 * x;
    scene.lights[0].direction = glm::normalize(scene.lights[0].direction + glm::dvec3(x, 0, 0));
    Probe after(context, std::move(scene), options);
    found.curve.push_back({x, changedInside(before, after), 0});
  }
  return found;
}

Found otherApi(const CaseContext& context) {
  ProbeOptions other = kOptions;
  other.onOther = true;
  Probe a(context, mixed(true), kOptions), b(context, mixed(true), other);
  return {.curve = {{1, pictureDifference(a, b), 1}}, .expected = ""};
}

Found finite(const CaseContext& context) {
  Probe probe(context, mixed(true), kOptions);
  return {.curve = {{1, badValues(probe), 0}}, .expected = ""};
}

Found emptyAndOdd(const CaseContext& context) {
  Scene empty;
  empty.cameras.push_back(lookAt({0, 0, 3}, {0, 0, 0}));
  Scene lightOnly = empty;
  addLight(lightOnly, sun({0, -1, 0}));
  Scene triangle = lightOnly;
  Mesh mesh = quadMesh(add(triangle, glass(0.5f, {1, 0.5f, 0})), {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  mesh.indices.resize(3);
  mesh.triangleKeys.resize(1);
  place(triangle, add(triangle, mesh));
  Found found;
  double x = 0;
  for (const Scene& scene : {empty, lightOnly, triangle, mixed(true)})
    for (const rhi::Extent2D size : {rhi::Extent2D{1, 1}, {37, 53}, {1, 4096}}) {
      if (size.height == 4096 && context.quick) continue;
      ProbeOptions options = kOptions;
      options.size = size;
      Probe probe(context, scene, options);
      found.curve.push_back({++x, badValues(probe), 0});
    }
  return found;
}

Found corners(const CaseContext& context) {
  Found found{.curve = {}, .expected = missing(context, Effect::TranslucentCasters)};
  double x = 0;
  for (const float alpha : {0.0f, 1.0f})
    for (const float t : {0.0f, 1.0f}) {
      Scene scene = floorScene();  // the camera is below what casts
      addHorizontal(scene, add(scene, glass(alpha, glm::vec3(t))), {0, 1, 0}, 4.5f, 4.5f);
      Probe probe(context, std::move(scene), kOptions);
      const double expected = alpha == 1 && t == 0 ? 0 : 1;
      const glm::dvec3 mean = probe.meanVisibility(0);
      found.curve.push_back({x++, std::abs(mean.x - expected), 0});
    }
  return found;
}

Found grazing(const CaseContext& context) {
  // Beyond atan(10) the bias of maps is clamped: light may be lost where N.L < .1, which costs at
  // most .1 of the illumination (spec 17, G11).
  Found found;
  for (const double angle : {45.0, 60.0, 75.0, 80.0, 84.0, 85.0, 87.0, 89.0, 89.5, 89.9}) {
    if (context.quick && angle != 60 && angle != 84 && angle < 89.5) continue;
    const double a = angle * std::numbers::pi / 180;
    Scene scene = floorScene();
    scene.lights[0] = sun({std::sin(a) * 0.8, -std::cos(a), std::sin(a) * 0.6});
    Probe probe(context, std::move(scene), kOptions);
    Compared lost;
    for (size_t i = 0; i < probe.visibility()[0].size(); i += 4)
      if (probe.visibility()[0][i + 3] > 0) lost.worst(1 - double(probe.visibility()[0][i]));
    const bool clamped = angle > 84.28;
    found.curve.push_back(
        {angle, clamped ? lost.value() * std::cos(a) : lost.value(), clamped ? 0.1 : 0.0});
  }
  return found;
}

std::string ofDeterministic(const CaseContext& context) {
  return context.info().stochastic ? "random numbers change with what is perturbed" : "";
}

std::string withOther(const CaseContext& context) {
  return context.other ? "" : "no other API is here to compare with";
}

}  // namespace

std::vector<StabilityCase> genericCases() {
  const std::string picture = "the picture stays (largest difference, 1/255)";
  std::vector<StabilityCase> cases = {
      {.id = "G1",
       .title = "The world moved",
       .property = picture,
       .reason = "exact: only differences to the eye are uploaded",
       .parameter = "offset, world units",
       .logarithmic = true,
       .asks = Asks::Both,
       .run = translated},
      {.id = "G2",
       .title = "The world scaled",
       .property = picture,
       .reason = "exact: scaling by powers of two is",
       .parameter = "factor",
       .logarithmic = true,
       .asks = Asks::Both,
       .run = scaled},
      {.id = "G3",
       .title = "Triangles and meshes permuted",
       .property = picture,
       .reason = "exact by persistent keys; products of half floats round as they are ordered",
       .run = permuted},
      {.id = "G3 lights",
       .title = "Lights permuted too",
       .property = picture,
       .reason = "a sum of three lights rounds as it is ordered",
       .run = permutedLights},
      {.id = "G4",
       .title = "Every opaque triangle twice",
       .property = picture,
       .reason = "exact: depth keeps the nearest",
       .asks = Asks::Both,
       .run = doubled},
      {.id = "G5",
       .title = "Triangles without area",
       .property = picture,
       .reason = "exact: they cover nothing",
       .asks = Asks::Both,
       .run = degenerate},
      {.id = "G6",
       .title = "One coordinate perturbed",
       .property = "visibility changes at edges alone (pixels elsewhere)",
       .reason = "none: a map is constant between its edges",
       .parameter = "relative change",
       .logarithmic = true,
       .leavesOut = ofDeterministic,
       .run = perturbed},
      {.id = "G7",
       .title = "The other API",
       .property = "the same picture (largest difference, 1/255)",
       .reason = "one step of the colour (decision D5)",
       .asks = Asks::Both,
       .leavesOut = withOther,
       .run = otherApi},
      {.id = "G8",
       .title = "Lights of every type",
       .property = "everything is finite, visibility in [0, 1] (values that are not)",
       .reason = "nothing is allowed",
       .asks = Asks::Both,
       .run = finite},
      {.id = "G9",
       .title = "Empty scenes and odd sizes",
       .property = "everything is finite, visibility in [0, 1] (values that are not)",
       .reason = "nothing is allowed",
       .asks = Asks::Both,
       .run = emptyAndOdd},
      {.id = "G10",
       .title = "Opacity and transmission 0 or 1",
       .property = "visibility is exactly 1, 1, 0, 1 (difference)",
       .reason = "exact",
       .parameter = "2 alpha + t",
       .run = corners},
      {.id = "G11",
       .title = "Grazing light",
       .property = "an unoccluded plane is lit (light lost, beyond 84.3 degrees times N.L)",
       .reason = "none to atan(10); beyond, what a clamped bias may lose costs a tenth",
       .parameter = "angle of incidence, degrees",
       .run = grazing},
  };
  for (StabilityCase& c : cases) c.onScene = sceneForm(c.id);
  return cases;
}

}  // namespace sb
